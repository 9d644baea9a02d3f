// SPDX-License-Identifier: MIT
// Does one body have a shared point elsewhere than all the others? In a file typed from one drawing
// that is a slip of the hand.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "moivre/mechanism/joint_type.h"
#include "read_parts.h"

namespace moivre {
namespace {

/// A joint that holds two points together, and how far apart they are typed.
struct Meeting {
  const Joint* joint = nullptr;
  double apart = 0;
};

const Eigen::Vector3d& typed_place(const Mechanism& mechanism, const PointOf& p) {
  return mechanism.bodies[p.body].points[p.point].at;
}

bool is_one_point(const PointOf& a, const PointOf& b) {
  return a.body == b.body && a.point == b.point;
}

bool holds_point(const Joint& joint, const PointOf& p) {
  return is_one_point(joint.at[0], p) || is_one_point(joint.at[1], p);
}

std::vector<Meeting> meetings_of(const Mechanism& mechanism) {
  std::vector<Meeting> all;
  for (const Joint& joint : mechanism.joints) {
    if (traits(joint.type).place != JointPlace::at_point || is_transmission(joint.type)) continue;
    const double apart =
        (typed_place(mechanism, joint.at[0]) - typed_place(mechanism, joint.at[1])).norm();
    all.push_back({&joint, apart});
  }
  return all;
}

/// Whether the points of all joints away from `p` agree, some of them not as origins of two frames,
/// and to a tenth of what `p` is off.
bool agree_elsewhere(const Mechanism& mechanism, const std::vector<Meeting>& meetings,
                     const PointOf& p, double off) {
  constexpr double kOutlier = 10;
  constexpr double kRounded = 1e-2;  // of where the points are: typed with three digits
  constexpr int kFewest = 2;
  int agreeing = 0;
  for (const Meeting& meeting : meetings) {
    if (holds_point(*meeting.joint, p)) continue;
    const double size = std::min(typed_place(mechanism, meeting.joint->at[0]).norm(),
                                 typed_place(mechanism, meeting.joint->at[1]).norm());
    if (meeting.apart * kOutlier > off) return false;
    if (size > 0 && meeting.apart > kRounded * size) return false;
    if (size > 0) ++agreeing;
  }
  return agreeing >= kFewest;
}

/// Whether another joint says that this point is where its neighbour has it.
bool is_confirmed(const std::vector<Meeting>& meetings, const PointOf& p, double off) {
  constexpr double kBeside = 0.1;
  return std::any_of(meetings.begin(), meetings.end(), [&](const Meeting& meeting) {
    return holds_point(*meeting.joint, p) && meeting.apart <= kBeside * off;
  });
}

std::string decimal_text(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.12g", x);
  return text;
}

std::string point_text(const Mechanism& mechanism, const PointOf& p) {
  const Body& body = mechanism.bodies[p.body];
  const Eigen::Vector3d& at = typed_place(mechanism, p);
  std::string text = body.name + '.' + body.points[p.point].name + " = [";
  const int size = mechanism.space == Space::planar ? 2 : 3;
  for (int k = 0; k < size; ++k) text += (k == 0 ? "" : ", ") + decimal_text(at[k]);
  return text + ']';
}

std::string distance_text(const Mechanism& mechanism, double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", x);
  return mechanism.units.length.empty() ? text : text + (' ' + mechanism.units.length);
}

}  // namespace

void warn_of_mistyped_point(Mechanism& mechanism) {
  const std::vector<Meeting> meetings = meetings_of(mechanism);
  const auto worst =
      std::max_element(meetings.begin(), meetings.end(),
                       [](const Meeting& a, const Meeting& b) { return a.apart < b.apart; });
  if (worst == meetings.end() || worst->apart == 0) return;
  for (const std::size_t end : {std::size_t{1}, std::size_t{0}}) {
    const PointOf& odd = worst->joint->at[end];
    const PointOf& other = worst->joint->at[1 - end];
    if (!agree_elsewhere(mechanism, meetings, odd, worst->apart)) continue;
    const bool is_other_odd = agree_elsewhere(mechanism, meetings, other, worst->apart);
    if (is_other_odd && is_confirmed(meetings, odd, worst->apart)) continue;
    const bool is_sure = !is_other_odd || is_confirmed(meetings, other, worst->apart);
    mechanism.warnings.push_back(point_text(mechanism, odd) + " and " +
                                 point_text(mechanism, other) + " are typed " +
                                 distance_text(mechanism, worst->apart) +
                                 " apart, and all other joints join points that are typed alike: " +
                                 (is_sure ? "is '" + mechanism.bodies[odd.body].name + "' mistyped?"
                                          : "is one of the two mistyped?"));
    return;
  }
}

}  // namespace moivre
