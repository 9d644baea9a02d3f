// SPDX-License-Identifier: MIT
// Circuits in words: their branches, what the driver does, how far each body goes; then the
// four-bar loops.
#include "circuits_report.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "id_list.h"
#include "moivre/closure_report/angles.h"
#include "moivre/closures/four_bars.h"
#include "moivre/expression/joined.h"
#include "moivre/mechanism/phi.h"
#include "moivre/report/number_text.h"
#include "pose_text.h"
#include "svg.h"

namespace moivre {
namespace {

// Radians, or of the mechanism's length: what goes no further stands, or keeps its slide.
constexpr double kStands = 1e-9;
// Of ranges and lengths.
constexpr int kRangeDigits = 6;

std::vector<std::string> ids_of(const std::vector<std::size_t>& branches,
                                const MotionResult& motion) {
  std::vector<std::string> ids;
  for (const std::size_t k : branches) ids.push_back(motion.branches[k].id);
  return ids;
}

std::string value_text(const Mechanism& mechanism, CoordinateKind kind, double value) {
  return coordinate_text(mechanism, {"", kind, 0}, value);
}

/// "16.0761 .. 220.337 deg": what a picture or a calliper shows; the events have more digits.
std::string range_text(const Mechanism& mechanism, const Swing& swing) {
  const bool is_length = swing.kind == CoordinateKind::length;
  const bool in_degrees = !is_length && mechanism.units.angle == "deg";
  const double unit = in_degrees ? 180 / std::numbers::pi : 1;
  const std::string& name = is_length ? mechanism.units.length : mechanism.units.angle;
  constexpr double kNoise =
      1e-6;  // of the range: an extreme's place is known to the root of rounding
  const double noise = kNoise * (swing.upper - swing.lower);
  const auto text = [&](double value) {
    return short_text(std::abs(value) <= noise ? 0 : unit * value, kRangeDigits);
  };
  return text(swing.lower) + " .. " + text(swing.upper) + (name.empty() ? "" : ' ' + name);
}

std::string swing_text(const Mechanism& mechanism, const Swing& swing) {
  if (swing.turns == 1) return swing.name + " turns fully";
  if (swing.turns > 1) return swing.name + " turns " + std::to_string(swing.turns) + " times";
  const bool is_length = swing.kind == CoordinateKind::length;
  const double size = is_length ? Phi(mechanism).length() : 1;
  const bool stands = swing.upper - swing.lower <= kStands * size;
  // A joint that slides may turn as well.
  if (stands) return swing.name + (is_length ? " keeps its slide" : " does not turn");
  return swing.name + (is_length ? " slides " : " rocks ") + range_text(mechanism, swing);
}

/// Where the first driver stands at these events, each place once: "12 deg, 45 deg".
std::string places_text(const std::vector<std::size_t>& events, const MotionResult& motion,
                        const Mechanism& mechanism) {
  constexpr double kTurn = 2 * std::numbers::pi;
  constexpr double kSame = 1e-7;  // a bifurcation is known to the root of rounding
  const CoordinateKind kind = kind_of(mechanism, mechanism.drivers.front());
  std::vector<double> values;
  for (const std::size_t k : events) {
    double value = motion.events[k].drivers.front();
    if (kind == CoordinateKind::angle) value -= kTurn * std::floor((value + kSame) / kTurn);
    if (std::abs(value) <= kSame) value = 0;
    const bool is_known = std::any_of(values.begin(), values.end(), [&](double known) {
      return std::abs(known - value) <= kSame;
    });
    if (!is_known) values.push_back(value);
  }
  std::vector<std::string> places;
  for (const double value : values) places.push_back(value_text(mechanism, kind, value));
  return joined(places, ", ");
}

/// By whole turns to where it holds the value that the driver begins with, if it does somewhere.
void bring_to(double begin, Swing& swing) {
  constexpr double kTurn = 2 * std::numbers::pi;
  if (swing.kind == CoordinateKind::length || swing.turns > 0) return;
  const double shift = kTurn * std::ceil((begin - swing.upper) / kTurn - kStands);
  if (swing.lower + shift > begin + kStands) return;
  swing.lower += shift;
  swing.upper += shift;
}

/// "crank rocks 16.0761 .. 220.337 deg between dead points".
std::string driver_text(const Circuit& circuit, const MotionResult& motion,
                        const Mechanism& mechanism) {
  if (circuit.drivers.empty()) return "no driver";
  Swing driver = circuit.drivers.front();
  driver.name = label_of(mechanism.drivers.front());
  bring_to(driver_state(mechanism.drivers.front().law, motion.from).value, driver);
  switch (circuit.driver_motion) {
    case DriverMotion::turns: {
      const std::string text = driver.name + " turns fully";
      return driver.turns == 1
                 ? text
                 : text + ", and all is as before after " + std::to_string(driver.turns) + " turns";
    }
    case DriverMotion::turns_over_dead_points:
      return driver.name + " turns fully only over dead points, at " +
             places_text(circuit.dead_points, motion, mechanism);
    case DriverMotion::open:
      return driver.name + " goes " + range_text(mechanism, driver) +
             " and further, out of the range";
    case DriverMotion::rocks:
      break;
  }
  const bool has_dead_points = !circuit.dead_points.empty();
  const char* between = has_dead_points && !circuit.stops.empty()
                            ? " between a dead point and a joint limit"
                        : has_dead_points        ? " between dead points"
                        : !circuit.stops.empty() ? " between joint limits"
                                                 : " as prescribed";
  return swing_text(mechanism, driver) + between;
}

/// Bodies and slides; of a spatial mechanism all joints. What is driven was told before.
std::string swings_text(const Circuit& circuit, const Mechanism& mechanism) {
  std::vector<std::string> parts;
  for (const Swing& swing : circuit.bodies) {
    const auto is_driven = [&](const Driver& driver) { return driver.name == swing.name; };
    if (std::any_of(mechanism.drivers.begin(), mechanism.drivers.end(), is_driven)) continue;
    parts.push_back(swing_text(mechanism, swing));
  }
  for (const Swing& swing : circuit.joints) {
    const bool is_told = circuit.bodies.empty() || swing.kind == CoordinateKind::length;
    if (is_told) parts.push_back(swing_text(mechanism, swing));
  }
  return joined(parts, "; ");
}

/// "E, C | D, F": each a stretch.
std::string stretches_text(const Circuit& circuit, const MotionResult& motion) {
  std::vector<std::string> parts;
  for (const std::vector<std::size_t>& stretch : circuit.stretches) {
    parts.push_back(id_list(ids_of(stretch, motion)));
  }
  return joined(parts, " | ");
}

/// Where all closures on both sides are known and one branch comes in and one goes out, there is
/// one way.
bool is_passed_in_one_way(const MotionEvent& event, const MotionResult& motion) {
  return motion.complete && !motion.checkpoints.empty() && event.ending.size() == 1 &&
         event.beginning.size() == 1;
}

std::string change_points_text(const Circuit& circuit, const MotionResult& motion,
                               const Mechanism& mechanism) {
  std::vector<std::size_t> open;
  std::vector<std::size_t> passed;
  for (const std::size_t k : circuit.change_points) {
    (is_passed_in_one_way(motion.events[k], motion) ? passed : open).push_back(k);
  }
  std::string text;
  if (!open.empty()) {
    text += "    change points at " + places_text(open, motion, mechanism) +
            ": which way it goes on is not determined there\n";
  }
  if (!passed.empty()) {
    text += "    singular poses at " + places_text(passed, motion, mechanism) +
            ": one branch comes in and one goes out, so that it goes on in one way\n";
  }
  return text;
}

std::string circuit_text(const Circuit& circuit, std::size_t number, const MotionResult& motion,
                         const Mechanism& mechanism) {
  std::string text = "  circuit " + std::to_string(number) + ": " +
                     id_list(ids_of(circuit.branches, motion)) + "; " +
                     driver_text(circuit, motion, mechanism) + '\n';
  if (circuit.stretches.size() > 1) {
    text += "    a dead point lies between " + stretches_text(circuit, motion) + '\n';
  }
  text += change_points_text(circuit, motion, mechanism);
  const std::string swings = swings_text(circuit, mechanism);
  return swings.empty() ? text : text + "    " + swings + '\n';
}

std::string rule_text(FourBarRule rule) {
  return rule == FourBarRule::grashof        ? "Grashof"
         : rule == FourBarRule::change_point ? "change point"
                                             : "not Grashof";
}

std::string four_bar_text(const FourBar& four_bar) {
  const char* sign = four_bar.rule == FourBarRule::grashof        ? " < "
                     : four_bar.rule == FourBarRule::change_point ? " = "
                                                                  : " > ";
  std::string text =
      "four-bar " + joined({four_bar.links.begin(), four_bar.links.end()}, ", ") + ": ";
  if (four_bar.type) {
    const std::string letters = barker_letters(*four_bar.type);
    text += to_string(*four_bar.type) + (letters.empty() ? "" : " (" + letters + ")");
  } else {
    text += rule_text(four_bar.rule);
  }
  // As many digits as tell the sums apart.
  int digits = kRangeDigits;
  const auto sums = [&] {
    return std::pair(short_text(four_bar.shortest_and_longest, digits),
                     short_text(four_bar.others, digits));
  };
  constexpr int kMostDigits = 15;
  while (four_bar.rule != FourBarRule::change_point && sums().first == sums().second &&
         digits < kMostDigits)
    ++digits;
  const auto [extremes, others] = sums();
  return text + ", s + l = " + extremes + sign + "p + q = " + others + '\n';
}

Json swing_json(const Swing& swing) {
  const bool has_range = swing.turns == 0;
  return {{"name", swing.name},
          {"kind", swing.kind == CoordinateKind::length ? "length" : "angle"},
          {"turns", swing.turns},
          {"lower", has_range ? to_json(swing.lower) : Json(nullptr)},
          {"upper", has_range ? to_json(swing.upper) : Json(nullptr)}};
}

Json circuit_json(const Circuit& circuit, std::size_t number, const MotionResult& motion) {
  return {{"number", number},
          {"branches", ids_of(circuit.branches, motion)},
          {"stretches", list_json(circuit.stretches,
                                  [&](const std::vector<std::size_t>& stretch) {
                                    return Json(ids_of(stretch, motion));
                                  })},
          {"driver", to_string(circuit.driver_motion)},
          {"drivers", list_json(circuit.drivers, swing_json)},
          {"bodies", list_json(circuit.bodies, swing_json)},
          {"joints", list_json(circuit.joints, swing_json)},
          {"dead_points", circuit.dead_points},
          {"change_points", circuit.change_points},
          {"stops", circuit.stops}};
}

/// Closures at `from` that lie on one circuit, two by two.
Json pairs_json(const Circuits& circuits, const MotionResult& motion) {
  Json pairs = Json::array();
  // Then each sub-chain has circuits of its own, and the whole has none.
  if (!motion.all_listed) return pairs;
  const std::vector<std::size_t> firsts = first_branches(motion);
  for (std::size_t a = 0; a < firsts.size(); ++a) {
    const std::vector<std::optional<Passage>> ways = passages_from(circuits, firsts[a]);
    for (std::size_t b = a + 1; b < firsts.size(); ++b) {
      const std::optional<Passage>& way = ways[firsts[b]];
      if (!way) continue;
      pairs.push_back({{"closures", ids_of({firsts[a], firsts[b]}, motion)},
                       {"dead_points", way->dead_points},
                       {"change_points", way->change_points}});
    }
  }
  return pairs;
}

Json four_bar_json(const FourBar& four_bar) {
  return {{"links", four_bar.links},
          {"lengths", list_json(four_bar.lengths, [](double x) { return to_json(x); })},
          {"rule", rule_text(four_bar.rule)},
          {"type", four_bar.type ? Json(to_string(*four_bar.type)) : Json(nullptr)},
          {"letters", four_bar.type ? Json(barker_letters(*four_bar.type)) : Json(nullptr)},
          {"shortest_and_longest", to_json(four_bar.shortest_and_longest)},
          {"others", to_json(four_bar.others)}};
}

}  // namespace

std::string circuits_text(const Circuits& circuits, const MotionResult& motion,
                          const Mechanism& mechanism) {
  std::string text;
  if (!circuits.circuits.empty()) {
    text += std::string("\nCircuits") + (circuits.is_full_turn ? " over a full turn" : "") +
            ": what can be reached without taking it apart\n";
  }
  for (std::size_t k = 0; k < circuits.circuits.size(); ++k) {
    text += circuit_text(circuits.circuits[k], k + 1, motion, mechanism);
  }
  if (!circuits.circuits.empty()) {
    for (const std::string& note : circuits.notes) text += "  note: " + note + '\n';
  }
  for (const FourBar& four_bar : four_bars(mechanism)) text += four_bar_text(four_bar);
  return text;
}

Json circuits_json(const Circuits& circuits, const MotionResult& motion,
                   const Mechanism& mechanism) {
  Json list = Json::array();
  for (std::size_t k = 0; k < circuits.circuits.size(); ++k) {
    list.push_back(circuit_json(circuits.circuits[k], k + 1, motion));
  }
  return {{"full_turn", circuits.is_full_turn},
          {"circuits", std::move(list)},
          {"circuit_notes", circuits.notes},
          {"pairs", pairs_json(circuits, motion)},
          {"four_bars", list_json(four_bars(mechanism), four_bar_json)}};
}

std::vector<BranchLook> branch_looks(const Circuits& circuits, const MotionResult& motion) {
  std::vector<BranchLook> looks(motion.branches.size());
  const bool is_told = circuits.circuits.size() < motion.branches.size();
  for (std::size_t k = 0; k < circuits.circuits.size(); ++k) {
    const Circuit& circuit = circuits.circuits[k];
    for (std::size_t stretch = 0; stretch < circuit.stretches.size(); ++stretch) {
      for (const std::size_t branch : circuit.stretches[stretch]) {
        looks[branch] = {k, dashes_text(k, stretch),
                         is_told ? "circuit " + std::to_string(k + 1) : ""};
      }
    }
  }
  return looks;
}

}  // namespace moivre
