// SPDX-License-Identifier: MIT
// Prim's tree by freedom, then the equations of the ties left over.
#include "spatial_tree.h"

#include <algorithm>
#include <map>
#include <optional>

#include "four_bars.h"
#include "planar_legs.h"
#include "struts.h"

namespace moivre {
namespace {

struct Node {
  std::size_t parent = 0;
  std::size_t depth = 0;
  MovingPose in_parent;
};

class Tree {
 public:
  Tree(SpatialFrame& frame, const RigidGroups& groups, const Part& part)
      : frame_(frame), groups_(groups), part_(part) {
    nodes_[0] = {0, 0, to_moving(ExactPose::identity())};
  }

  void build() {
    while (nodes_.size() <= part_.groups.size()) place_next();
    for (const std::size_t k : part_.ties) {
      if (std::find(used_.begin(), used_.end(), k) == used_.end()) close(groups_.ties[k]);
    }
    for (const DrivenPoint& driven : groups_.driven_points) {
      if (nodes_.count(driven.group) > 0 && driven.group != 0) drive(driven);
    }
    for (const Strut& strut : groups_.struts) stand(strut, strut.cross.i, strut.ball.i);
    for (const PlanarLeg& leg : groups_.legs) stand(leg, leg.first.i, leg.last.i);
    for (const FourBarLeg& four_bar : groups_.four_bars) {
      stand(four_bar, four_bar.bar.i, four_bar.foot.i);
    }
  }

 private:
  /// The postures of links that were left out, where the groups that they join are placed here.
  template <class Links>
  void stand(const Links& links, std::size_t i, std::size_t k) {
    if (nodes_.count(i) == 0 || nodes_.count(k) == 0) return;
    add_postures(frame_, groups_, links, relative(i, k));
  }

  void place_next() {
    std::optional<std::size_t> stiffest;
    std::map<std::size_t, std::size_t> loose;  // ties of groups not yet placed
    for (const std::size_t k : part_.ties) {
      const Tie& tie = groups_.ties[k];
      if (nodes_.count(tie.i) == nodes_.count(tie.j)) continue;
      const std::size_t next = nodes_.count(tie.i) > 0 ? tie.j : tie.i;
      if (is_loose(tie)) {
        ++loose[next];
      } else if (!stiffest || freedom(tie) < freedom(groups_.ties[*stiffest])) {
        stiffest = k;
      }
    }
    if (stiffest) {
      const Tie& typed = groups_.ties[*stiffest];
      const Tie tie = nodes_.count(typed.i) > 0 ? typed : reversed(typed);
      used_.push_back(*stiffest);
      place(tie.j, tie.i, add_motion(frame_, tie, groups_.bodies[tie.j]));
      return;
    }
    const auto most =
        std::max_element(loose.begin(), loose.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    const std::size_t group = most->first;
    place(group, 0, frame_.add_any_pose(groups_.names[group], groups_.bodies[group]));
  }

  void place(std::size_t group, std::size_t parent, MovingPose in_parent) {
    frame_.place(group, parent, in_parent);
    nodes_[group] = {parent, nodes_[parent].depth + 1, std::move(in_parent)};
  }

  void close(const Tie& tie) {
    if (is_meeting(tie)) {
      frame_.add_equation(tie.name + ": lines",
                          meeting_equation(frame_, tie, relative(tie.i, tie.j)));
      return;
    }
    if (!is_rod(tie)) {
      add_closing(frame_, tie, relative(tie.i, tie.j));
      return;
    }
    Polynomial length = rod_equation(frame_, tie, relative(tie.i, tie.j));
    const auto [first, is_new] = first_rod_.emplace(std::minmax(tie.i, tie.j), length);
    if (!is_new) length = frame_.difference(length, first->second);
    frame_.add_equation(tie.name + ": length", std::move(length));
  }

  void drive(const DrivenPoint& driven) {
    const MovingPose at = relative(0, driven.group) * to_moving(driven.point);
    const Polynomial shift = product(at.g, conjugate(at.q))[driven.axis + 1];
    frame_.add_equation("driver " + driven.name,
                        Coefficient{2, 0} * shift - Coefficient{driven.value, 0} * dot(at.q, at.q));
  }

  /// Pose of group j in group i, from where their branches part.
  MovingPose relative(std::size_t i, std::size_t j) const {
    MovingPose to_i = to_moving(ExactPose::identity());
    MovingPose to_j = to_i;
    while (i != j) {
      const Node& node_i = nodes_.at(i);
      const Node& node_j = nodes_.at(j);
      if (node_i.depth >= node_j.depth) {
        to_i = node_i.in_parent * to_i;
        i = node_i.parent;
      } else {
        to_j = node_j.in_parent * to_j;
        j = node_j.parent;
      }
    }
    return conjugate(to_i) * to_j;
  }

  SpatialFrame& frame_;
  const RigidGroups& groups_;
  const Part& part_;
  std::map<std::size_t, Node> nodes_;
  std::vector<std::size_t> used_;
  std::map<std::pair<std::size_t, std::size_t>, Polynomial> first_rod_;
};

}  // namespace

void add_tree(SpatialFrame& frame, const RigidGroups& groups, const Part& part) {
  Tree(frame, groups, part).build();
}

}  // namespace moivre
