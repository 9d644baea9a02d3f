// SPDX-License-Identifier: MIT
// One table of the units that a joint value may have: two of angle, two of length.
#include "joint_value.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

namespace moivre {
namespace {

struct Unit {
  std::string_view name;
  double size = 1;
  bool is_length = false;
};

constexpr std::array<Unit, 4> kUnits{{{"rad", 1, false},
                                      {"deg", std::numbers::pi / 180, false},
                                      {"m", 1, true},
                                      {"mm", 1e-3, true}}};

const Unit* unit_named(std::string_view name) {
  const auto* const found = std::find_if(kUnits.begin(), kUnits.end(),
                                         [&](const Unit& unit) { return unit.name == name; });
  return found == kUnits.end() ? nullptr : found;
}

}  // namespace

std::optional<TypedJointValue> read_joint_value(std::string_view text) {
  double number = 0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, number);
  if (read.ec != std::errc() || !std::isfinite(number)) return std::nullopt;
  const std::string_view name(read.ptr, static_cast<std::size_t>(end - read.ptr));
  if (name.empty()) return TypedJointValue{number, ""};
  const Unit* const unit = unit_named(name);
  if (unit == nullptr) return std::nullopt;
  return TypedJointValue{number * unit->size, std::string(name)};
}

std::string unit_fault(const TypedJointValue& value, bool is_slide) {
  const Unit* const unit = unit_named(value.unit);
  if (unit == nullptr || unit->is_length == is_slide) return "";
  return is_slide ? "the joint slides: its value is in m or mm"
                  : "the joint turns: its value is in rad or deg";
}

}  // namespace moivre
