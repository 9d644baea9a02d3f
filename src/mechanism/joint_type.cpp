// SPDX-License-Identifier: MIT
// The table of joint types, and what follows from a row.
#include "moivre/mechanism/joint_type.h"

#include <stdexcept>

namespace moivre {
const std::vector<JointTraits>& all_joint_types() {
  using P = JointPlace;
  using T = JointTurn;
  static const std::vector<JointTraits> table{
      {JointType::revolute, "revolute", P::at_point, T::about_axis, true, true},
      {JointType::prismatic, "prismatic", P::on_line, T::not_at_all, true, true},
      {JointType::slot, "slot", P::on_line, T::about_axis, true, false},
      {JointType::weld, "weld", P::at_point, T::not_at_all, true, true},
      {JointType::rod, "rod", P::at_distance, T::freely, true, true},
      {JointType::actuator, "actuator", P::at_any_distance, T::freely, true, true},
      {JointType::gear, "gear", P::anywhere, T::geared, true, false},
      {JointType::belt, "belt", P::anywhere, T::geared, true, false},
      {JointType::rack, "rack", P::off_line, T::by_rack, true, false},
      {JointType::cam, "cam", P::off_line, T::by_cam, true, false},
      {JointType::cam_lever, "cam-lever", P::anywhere, T::by_cam, true, false},
      {JointType::spherical, "spherical", P::at_point, T::freely, false, true},
      {JointType::cylindrical, "cylindrical", P::on_line, T::about_axis, false, true},
      {JointType::universal, "universal", P::at_point, T::about_two_axes, false, true},
      {JointType::screw, "screw", P::on_line, T::by_thread, false, true},
      {JointType::planar, "planar", P::in_plane, T::about_axis, false, true},
      {JointType::point_on_line, "point-on-line", P::on_line, T::freely, false, true},
      {JointType::point_on_plane, "point-on-plane", P::in_plane, T::freely, false, true}};
  return table;
}

const JointTraits& traits(JointType type) {
  return all_joint_types()[static_cast<std::size_t>(type)];
}

int row_count(JointPlace place, Space space) {
  const bool is_planar = space == Space::planar;
  switch (place) {
    case JointPlace::anywhere:
    case JointPlace::off_line:
    case JointPlace::at_any_distance:
      return 0;
    case JointPlace::at_distance:
    case JointPlace::in_plane:
      return 1;
    case JointPlace::on_line:
      return is_planar ? 1 : 2;
    case JointPlace::at_point:
      return is_planar ? 2 : 3;
  }
  return 0;
}

int row_count(JointTurn turn, Space space) {
  const bool is_planar = space == Space::planar;
  switch (turn) {
    case JointTurn::freely:
      return 0;
    case JointTurn::about_two_axes:
    case JointTurn::by_rack:
    case JointTurn::by_cam:
    case JointTurn::geared:
      return 1;
    case JointTurn::about_axis:
      return is_planar ? 0 : 2;
    case JointTurn::by_thread:
      return 3;
    case JointTurn::not_at_all:
      return is_planar ? 1 : 3;
  }
  return 0;
}

bool exists_in(Space space, const JointTraits& type) {
  return space == Space::planar ? type.is_planar : type.is_spatial;
}

int freedoms(JointType type, Space space) {
  const JointTraits& row = traits(type);
  const bool is_planar = space == Space::planar;
  if (!exists_in(space, row)) {
    throw std::logic_error(std::string("a ") + (is_planar ? "planar" : "spatial") +
                           " mechanism has no " + row.name + " joint");
  }
  return (is_planar ? 3 : 6) - row_count(row.place, space) - row_count(row.turn, space);
}

bool has_line(JointType type) {
  return traits(type).place == JointPlace::on_line || traits(type).place == JointPlace::off_line;
}

bool is_transmission(JointType type) {
  const JointTurn turn = traits(type).turn;
  return turn == JointTurn::geared || turn == JointTurn::by_rack || turn == JointTurn::by_cam;
}

bool has_rows(JointType type, Space space) {
  return row_count(traits(type).place, space) + row_count(traits(type).turn, space) > 0;
}

bool has_slide(JointType type) {
  return has_line(type) || traits(type).place == JointPlace::at_any_distance;
}

bool has_angle(JointType type) {
  return traits(type).turn == JointTurn::about_axis || traits(type).turn == JointTurn::by_thread;
}

bool is_angular(JointType type) { return has_angle(type) && !has_slide(type); }

int axis_count(JointType type) {
  const JointTraits& row = traits(type);
  if (row.turn != JointTurn::freely && row.turn != JointTurn::geared) return 2;
  return row.place == JointPlace::in_plane || row.place == JointPlace::on_line ? 1 : 0;
}

std::string to_string(JointType type) { return traits(type).name; }

}  // namespace moivre
