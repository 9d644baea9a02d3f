// SPDX-License-Identifier: MIT
// Lines of numbers, and what is wrong with them.
#include "moivre/arms/poses.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "moivre/expression/words.h"
#include "moivre/mechanism/mechanism.h"

namespace moivre {
namespace {

constexpr std::string_view kBetween = " \t,;\r\v\f";
constexpr std::size_t kNumbers = 7;

struct Word {
  std::string_view text;
  SourcePosition at;
};

std::vector<Word> words_of(std::string_view line, SourcePosition begin) {
  std::vector<Word> words;
  std::size_t k = 0;
  while ((k = line.find_first_not_of(kBetween, k)) != std::string_view::npos) {
    const std::size_t end = std::min(line.find_first_of(kBetween, k), line.size());
    words.push_back({line.substr(k, end - k), {begin.offset + k, begin.line, begin.column + k}});
    k = end;
  }
  return words;
}

/// Decimals of a number as typed.
int decimals_of(std::string_view word) {
  const std::size_t exponent = word.find_first_of("eE");
  const std::string_view mantissa = word.substr(0, exponent);
  const std::size_t point = mantissa.find('.');
  const auto behind =
      point == std::string_view::npos ? 0 : static_cast<int>(mantissa.size() - point - 1);
  if (exponent == std::string_view::npos) return behind;
  const auto shift = to_number(word.substr(exponent + 1));
  return behind - static_cast<int>(shift.value_or(0));
}

double accuracy_of(const std::vector<Word>& words) {
  constexpr int kFewest = 3, kMost = 11;
  int most = 0;
  for (const Word& word : words) most = std::max(most, decimals_of(word.text));
  return most < kFewest || most > kMost ? 0 : 2 * std::pow(10, -most);
}

/// The pose of one line, or a fault.
std::optional<TypedPose> read_pose(const std::vector<Word>& words,
                                   std::vector<Diagnostic>& faults) {
  if (words.size() != kNumbers) {
    faults.push_back({words.front().at, "a pose is seven numbers, x y z qw qx qy qz, not " +
                                            std::to_string(words.size())});
    return std::nullopt;
  }
  std::vector<double> x;
  for (const Word& word : words) {
    const auto number = to_number(word.text);
    if (number && std::isfinite(*number) && is_workable(*number)) {
      x.push_back(*number);
    } else {
      faults.push_back({word.at, "this is no finite number"});
    }
  }
  if (x.size() != kNumbers) return std::nullopt;
  const Eigen::Quaterniond q(x[3], x[4], x[5], x[6]);
  if (std::abs(q.norm() - 1) > kRoundedBy) {
    faults.push_back(
        {words[3].at, "qw qx qy qz has length " + std::to_string(q.norm()) +
                          ", a unit quaternion is wanted: turn by a about the unit vector u is "
                          "cos(a/2) u sin(a/2)"});
    return std::nullopt;
  }
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translate(Eigen::Vector3d(x[0], x[1], x[2]));
  pose.rotate(q.normalized());
  return TypedPose{pose, accuracy_of(words)};
}

bool are_names(const std::vector<Word>& words) {
  return std::none_of(words.begin(), words.end(),
                      [](const Word& word) { return to_number(word.text).has_value(); });
}

}  // namespace

std::vector<TypedPose> read_poses(const Source& source) {
  std::vector<TypedPose> poses;
  std::vector<Diagnostic> faults;
  const std::string_view text = source.text;
  SourcePosition begin;
  bool may_be_names = true;
  while (begin.offset < text.size()) {
    const std::size_t end = std::min(text.find('\n', begin.offset), text.size());
    const std::vector<Word> words = words_of(text.substr(begin.offset, end - begin.offset), begin);
    const bool is_comment = !words.empty() && words.front().text.starts_with('#');
    if (!words.empty() && !is_comment) {
      if (!may_be_names || !are_names(words)) {
        if (const auto pose = read_pose(words, faults)) poses.push_back(*pose);
      }
      may_be_names = false;
    }
    begin = {end + 1, begin.line + 1, 1};
  }
  if (poses.empty() && faults.empty()) faults.push_back({{}, "there is no pose"});
  if (!faults.empty()) throw ParseError(source, std::move(faults));
  return poses;
}

}  // namespace moivre
