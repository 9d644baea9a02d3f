// SPDX-License-Identifier: MIT
// Loops of four links and four pins; the shortest and the longest link say the type.
#include "moivre/closures/four_bars.h"

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <cmath>
#include <map>
#include <numeric>
#include <queue>
#include <set>

namespace moivre {
namespace {

// Of the sum of all lengths.
constexpr double kEqual = 1e-9;

struct TypeName {
  const char* name;
  const char* letters;
};

/// In the order of FourBarType.
constexpr std::array<TypeName, 15> kNames{{
    {"double-crank", "GCCC"},
    {"crank-rocker", "GCRR"},
    {"double-rocker", "GRCR"},
    {"rocker-crank", "GRRC"},
    {"triple-rocker", "RRR1"},
    {"triple-rocker", "RRR2"},
    {"triple-rocker", "RRR3"},
    {"triple-rocker", "RRR4"},
    {"double-crank with change points", "SCCC"},
    {"crank-rocker with change points", "SCRR"},
    {"double-rocker with change points", "SRCR"},
    {"rocker-crank with change points", "SRRC"},
    {"two pairs of equal links, with change points", "S2X"},
    {"four equal links, with change points", "S3X"},
    {"cannot be closed", ""},
}};

struct Sorted {
  double s_and_l = 0;
  double p_and_q = 0;
  std::size_t shortest = 0;
  std::size_t longest = 0;
  double noise = 0;
};

Sorted sorted(const std::array<double, 4>& lengths) {
  Sorted all;
  all.shortest =
      static_cast<std::size_t>(std::min_element(lengths.begin(), lengths.end()) - lengths.begin());
  all.longest =
      static_cast<std::size_t>(std::max_element(lengths.begin(), lengths.end()) - lengths.begin());
  const double sum = std::accumulate(lengths.begin(), lengths.end(), 0.0);
  all.s_and_l = lengths[all.shortest] + lengths[all.longest];
  all.p_and_q = sum - all.s_and_l;
  all.noise = kEqual * sum;
  return all;
}

/// Types of one kind stand in the order of the links that they are named by.
FourBarType type_by_link(FourBarType first, std::size_t link) {
  return static_cast<FourBarType>(static_cast<std::size_t>(first) + link);
}

FourBarType change_point_type(const std::array<double, 4>& lengths, const Sorted& all) {
  const auto equal = [&](double x, double y) { return std::abs(x - y) <= all.noise; };
  const auto is_as_short = [&](double x) { return equal(x, lengths[all.shortest]); };
  const auto short_ones = std::count_if(lengths.begin(), lengths.end(), is_as_short);
  if (short_ones == 4) return FourBarType::four_equal_sides;
  if (short_ones == 2) return FourBarType::two_equal_pairs;
  return type_by_link(FourBarType::change_point_double_crank, all.shortest);
}

/// A body, or a rod.
struct Link {
  std::string name;
  bool is_rod = false;
  double rod_length = 0;
};

/// A link's place at a pin.
struct Pinned {
  std::size_t link = 0;
  std::size_t point = 0;  ///< of a body its point, of a rod its end
  std::size_t pin = 0;
};

/// Links, and the pins that hold them together: points that revolutes (and rods' ends) make one.
class PinnedLinks {
 public:
  explicit PinnedLinks(const Mechanism& mechanism);

  std::vector<FourBar> loops() const;

 private:
  using Loop =
      std::array<std::array<Pinned, 2>, 4>;  ///< of each link, where it comes from and goes to

  std::vector<std::size_t> steps_from_drivers() const;
  double length(const std::array<Pinned, 2>& ends) const;
  std::optional<FourBar> four_bar(Loop loop, const std::vector<std::size_t>& steps) const;
  static bool has_four_pins(const Loop& loop);
  template <typename Visit>
  void go_on(Loop& loop, std::size_t depth, const Visit& visit) const;

  const Mechanism& mechanism_;
  std::vector<Link> links_;
  std::vector<Pinned> places_;
};

PinnedLinks::PinnedLinks(const Mechanism& mechanism) : mechanism_(mechanism) {
  for (const Body& body : mechanism.bodies) links_.push_back({body.name, false, 0});
  std::vector<std::array<Pinned, 2>> pairs;
  for (const Joint& joint : mechanism.joints) {
    const Pinned a{joint.at[0].body, joint.at[0].point, 0};
    const Pinned b{joint.at[1].body, joint.at[1].point, 0};
    if (joint.type == JointType::revolute) pairs.push_back({a, b});
    if (joint.type != JointType::rod) continue;
    const std::size_t rod = links_.size();
    links_.push_back({joint.name, true, joint.length});
    pairs.push_back({Pinned{rod, 0, 0}, a});
    pairs.push_back({Pinned{rod, 1, 0}, b});
  }
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> number;
  const auto number_of = [&](const Pinned& place) {
    return number.try_emplace({place.link, place.point}, number.size()).first->second;
  };
  for (const auto& [a, b] : pairs) {
    number_of(a);
    number_of(b);
  }
  boost::disjoint_sets_with_storage<> pins(number.size());
  for (std::size_t k = 0; k < number.size(); ++k) pins.make_set(k);
  for (const auto& [a, b] : pairs) pins.union_set(number_of(a), number_of(b));
  for (const auto& [place, k] : number) {
    places_.push_back({place.first, place.second, pins.find_set(k)});
  }
}

/// Of each link, how many joints lie between it and a driven body, not counting ways over the
/// ground.
std::vector<std::size_t> PinnedLinks::steps_from_drivers() const {
  std::vector<std::vector<std::size_t>> beside(links_.size());
  const auto connect = [&](std::size_t a, std::size_t b) {
    if (a == 0 || b == 0) return;
    beside[a].push_back(b);
    beside[b].push_back(a);
  };
  for (const Joint& joint : mechanism_.joints) connect(joint.at[0].body, joint.at[1].body);
  for (const Pinned& a : places_) {
    for (const Pinned& b : places_) {
      if (a.pin == b.pin && a.link < b.link) connect(a.link, b.link);
    }
  }
  std::vector<std::size_t> steps(links_.size(), links_.size());
  std::queue<std::size_t> open;
  const auto reach = [&](std::size_t link, std::size_t count) {
    if (link == 0 || steps[link] <= count) return;
    steps[link] = count;
    open.push(link);
  };
  for (const Driver& driver : mechanism_.drivers) {
    for (const std::size_t body : bodies_of(mechanism_, driver)) reach(body, 0);
  }
  while (!open.empty()) {
    const std::size_t here = open.front();
    open.pop();
    for (const std::size_t there : beside[here]) reach(there, steps[here] + 1);
  }
  return steps;
}

double PinnedLinks::length(const std::array<Pinned, 2>& ends) const {
  const Link& link = links_[ends[0].link];
  if (link.is_rod) return link.rod_length;
  const std::vector<BodyPoint>& points = mechanism_.bodies[ends[0].link].points;
  return (points[ends[0].point].at - points[ends[1].point].at).norm();
}

/// nullopt where two of the pins stand at one place of a link.
std::optional<FourBar> PinnedLinks::four_bar(Loop loop,
                                             const std::vector<std::size_t>& steps) const {
  // The loop begins with its first link, which is the ground where that is one.
  const bool has_ground = loop[0][0].link == 0;
  if (has_ground && steps[loop[3][0].link] < steps[loop[1][0].link]) {
    std::swap(loop[1], loop[3]);
  }
  FourBar found;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    found.links[k] = links_[loop[k][0].link].name;
    found.lengths[k] = length(loop[k]);
    if (!(found.lengths[k] > 0)) return std::nullopt;
  }
  const Sorted all = sorted(found.lengths);
  found.rule = four_bar_rule(found.lengths);
  if (has_ground) found.type = four_bar_type(found.lengths);
  found.shortest_and_longest = all.s_and_l;
  found.others = all.p_and_q;
  return found;
}

/// Visits every loop whose first `depth` links are known.
template <typename Visit>
void PinnedLinks::go_on(Loop& loop, std::size_t depth, const Visit& visit) const {
  const Pinned& out = loop[depth - 1][1];
  if (depth == loop.size()) {
    if (out.pin == loop[0][0].pin) visit(loop);
    return;
  }
  const auto is_passed = [&](const Pinned& place) {
    for (std::size_t k = 0; k < depth; ++k) {
      if (loop[k][0].link == place.link) return true;
    }
    return place.link < loop[0][0].link;
  };
  for (const Pinned& in : places_) {
    if (in.pin != out.pin || is_passed(in)) continue;
    for (const Pinned& next : places_) {
      if (next.link != in.link || next.pin == in.pin) continue;
      loop[depth] = {in, next};
      go_on(loop, depth + 1, visit);
    }
  }
}

bool PinnedLinks::has_four_pins(const Loop& loop) {
  std::set<std::size_t> pins;
  for (const auto& ends : loop) pins.insert(ends[0].pin);
  return pins.size() == loop.size();
}

std::vector<FourBar> PinnedLinks::loops() const {
  const std::vector<std::size_t> steps = steps_from_drivers();
  std::vector<FourBar> found;
  for (const Pinned& first : places_) {
    for (const Pinned& out : places_) {
      if (out.link != first.link || out.pin == first.pin) continue;
      Loop loop{};
      loop[0] = {first, out};
      go_on(loop, 1, [&](const Loop& whole) {
        // Each loop is met in both directions.
        if (whole[1][0].link > whole[3][0].link || !has_four_pins(whole)) return;
        if (const auto one = four_bar(whole, steps)) found.push_back(*one);
      });
    }
  }
  return found;
}

}  // namespace

std::string to_string(FourBarType type) { return kNames[static_cast<std::size_t>(type)].name; }

std::string barker_letters(FourBarType type) {
  return kNames[static_cast<std::size_t>(type)].letters;
}

FourBarRule four_bar_rule(const std::array<double, 4>& lengths) {
  const Sorted all = sorted(lengths);
  const double excess = all.s_and_l - all.p_and_q;
  if (std::abs(excess) <= all.noise) return FourBarRule::change_point;
  return excess < 0 ? FourBarRule::grashof : FourBarRule::non_grashof;
}

FourBarType four_bar_type(const std::array<double, 4>& lengths) {
  const Sorted all = sorted(lengths);
  const double longest = lengths[all.longest];
  if (longest - (all.s_and_l + all.p_and_q - longest) > all.noise) {
    return FourBarType::cannot_be_closed;
  }
  switch (four_bar_rule(lengths)) {
    case FourBarRule::grashof:
      return type_by_link(FourBarType::double_crank, all.shortest);
    case FourBarRule::non_grashof:
      return type_by_link(FourBarType::triple_rocker_frame, all.longest);
    case FourBarRule::change_point:
      break;
  }
  return change_point_type(lengths, all);
}

std::vector<FourBar> four_bars(const Mechanism& mechanism) {
  if (is_typed(mechanism) || mechanism.space == Space::spatial) return {};
  return PinnedLinks(mechanism).loops();
}

}  // namespace moivre
