// SPDX-License-Identifier: MIT
// What is the mechanism? Bodies with named points, joints and drivers; or constraint equations
// typed by hand.
//
// A file is one of two kinds (is_typed tells which):
//   bodies     bodies[0] is the ground; joints tie bodies, drivers move them;
//   equations  unknowns (q, in their order), constants and equations f(q, t) = 0.
// Angles are radians and lengths are in the file's unit, whatever unit the file was written in.
// A planar point has z = 0. Coordinates: planar [x, y, phi] a body, spatial [x, y, z, rx, ry, rz] a
// body (rotation vector, docs/decisions/0010-spatial-coordinates.md), ground none.
// Not supported: velocity (non-holonomic) and one-sided constraints; the reader refuses them with
// the reason.
#pragma once

#include <Eigen/Core>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "moivre/expression/expression.h"
#include "moivre/mechanism/driver_law.h"

namespace moivre {

enum class Space { planar, spatial };

/// joint_type.h says what each is.
enum class JointType {
  revolute,
  prismatic,
  slot,  ///< planar
  weld,
  rod,
  actuator,  ///< a cylinder: a rod whose length is its slide
  gear,      ///< planar; two bodies turn in an integer ratio as seen from a carrier
  belt,      ///< planar; likewise, by the radii of two pulleys
  rack,      ///< planar; the second body's pitch circle rolls along a line of the first
  cam,  ///< planar; the second body slides along a line of a carrier, by the angle of the first
  cam_lever,  ///< planar; the second body turns, likewise
  spherical,
  cylindrical,
  universal,
  screw,
  planar,
  point_on_line,
  point_on_plane
};

std::string to_string(JointType type);

/// What the file's numbers were written in; `angle` is "rad" or "deg".
struct Units {
  std::string length;
  std::string angle = "rad";
};

/// A place fixed in a body's own frame.
struct BodyPoint {
  std::string name;
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  SourcePosition where;
};

struct Body {
  std::string name;
  std::vector<BodyPoint> points;
  SourcePosition where;
};

/// Point `point` of body `body`, both counted from 0.
struct PointOf {
  std::size_t body = 0;
  std::size_t point = 0;
};

/// Teeth of the two wheels, signed: equal signs turn alike (internal mesh, open belt), opposite
/// signs against each other (external mesh, crossed belt). Of pulleys, whole numbers in the ratio
/// of their radii.
struct Gear {
  std::array<int, 2> teeth{1, 1};
  std::array<double, 2> radii{0, 0};  ///< belt
  std::size_t carrier = 0;            ///< body; angles are relative to it
  /// Angle of the second wheel where the first stands at 0, of a pinion where its rack does; of a
  /// cam where its profile begins.
  double phase_rad = 0;
  bool has_all_meshings =
      false;  ///< closures in every meshing of the teeth, not in the drawn one alone
};

struct Limits {
  double lower = 0;
  double upper = 0;
};

/// Which fields a type reads is said beside them; the others keep their default.
struct Joint {
  JointType type = JointType::revolute;
  std::string name;           ///< given, or made from its points
  std::array<PointOf, 2> at;  ///< gear, belt, cam-lever: the bodies only
  std::array<Eigen::Vector3d, 2> axis{Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitX()};
  ///< unit vectors, one in each body's frame. Planar: axis[0], the line of a prismatic joint, slot
  ///< or rack; a cam's in its carrier. Spatial: the joint's axis or the plane's normal; the two
  ///< pins of universal; axis[0] of a point on a line or plane
  double turn_rad = 0;  ///< prismatic, weld: angle of the second body relative to the first
  double length = 0;    ///< rod; actuator that stands at a length, else 0
  double radius =
      0;  ///< rack: of the pinion's pitch circle, negative where that is on the line's left
  double pitch =
      0;           ///< screw: advance of the second body for a whole turn, negative if left-handed
  Gear gear;       ///< of transmissions
  Spline profile;  ///< cam, cam-lever: the lift by the cam's angle, over a whole turn
  std::optional<Limits> limits;  ///< of its coordinate: the slide where it has one, else the angle
  SourcePosition where;
};

/// The body in which the joint's line is fixed.
std::size_t line_body(const Joint& joint);

enum class DriverKind {
  angle,  ///< angle of `bodies[1]` relative to `bodies[0]`; spatial: of `joint`
  slide,  ///< displacement along `joint`
  x,      ///< coordinate of `point` in the ground frame
  y,
  z,
  unknown  ///< the unknown `unknown` of a typed mechanism
};

std::string to_string(DriverKind kind);

struct Driver {
  DriverKind kind = DriverKind::angle;
  std::string name;  ///< what it drives, as typed
  std::array<std::size_t, 2> bodies{0, 0};
  std::size_t joint = 0;
  PointOf point;
  std::size_t unknown = 0;
  DriverLaw law;
  SourcePosition where;
};

/// A freedom on which nothing depends: a body, with all that cannot turn against it, turns about
/// the line through two points.
struct Spin {
  std::size_t body = 0;
  std::array<PointOf, 2> line;
};

struct Unknown {
  std::string name;
  bool is_angle = false;
  SourcePosition where;
};

/// expression = 0.
struct Equation {
  std::string name;
  Expression expression;
  Formula formula;
  SourcePosition where;
};

struct Mechanism {
  std::string title;
  Space space = Space::planar;
  Units units;

  std::vector<Body> bodies{Body{"ground", {}, {}}};
  std::vector<Joint> joints;
  std::vector<Spin> held_spins;  ///< each held by a row of Phi (spins.h); none as read from a file

  std::vector<Unknown> unknowns;
  std::map<std::string, double> constants;
  std::vector<Equation> equations;

  std::vector<Driver> drivers;
  std::map<std::string, double>
      guess;  ///< coordinate name -> value, for the coordinates that the file names
  std::optional<double>
      fit;  ///< closures that miss by no more than this are taken, lengths in the file's unit
  std::optional<double> tolerance;  ///< of points' coordinates and rods, in the file's unit
  std::map<std::string, double>
      tolerances;  ///< of the dimensions (dimensions.h) that the file gives one of their own
  std::vector<std::string> warnings;  ///< what is odd but not wrong, each a sentence
};

/// The bodies that a joint ties, the carrier of a transmission among them.
std::vector<std::size_t> bodies_of(const Joint& joint);
/// The bodies whose places a driver prescribes.
std::vector<std::size_t> bodies_of(const Mechanism& mechanism, const Driver& driver);

bool is_typed(const Mechanism& mechanism);

/// A number beyond this is refused: products of half a dozen lengths stay within double.
inline constexpr double kLargestSize = 1e50;
bool is_workable(double number);

/// An angle further from 0 than so many turns (in radians: 6e6) is refused: double rounds it by
/// 1e-9 rad.
inline constexpr double kMostTurns = 1e6;
bool is_workable_angle(double angle_rad);

/// Throws std::invalid_argument, which names every driver, where t or what a driver prescribes at t
/// cannot be worked with.
void require_drivers(const Mechanism& mechanism, double t);

enum class CoordinateKind { length, angle, rotation_vector };

struct Coordinate {
  std::string name;  ///< "crank.phi", or the unknown's name
  CoordinateKind kind = CoordinateKind::length;
  std::size_t group = 0;     ///< which moving body (0 the first behind ground), or which unknown
  bool is_periodic = false;  ///< an angle for which a whole turn more is the same pose
};

/// q, in its order. An unknown angle that equations use outside sin, cos and tan, or with a factor
/// that is not whole, is not periodic.
std::vector<Coordinate> coordinates(const Mechanism& mechanism);

/// Whether the driver prescribes an angle, or a length.
CoordinateKind kind_of(const Mechanism& mechanism, const Driver& driver);

/// What it drives, "coupler.P.x" where it is a point's coordinate.
std::string label_of(const Driver& driver);

/// A start for Newton's method. Coordinates come from the file's guess, and driven angles from
/// their drivers at time t. Other positions x, y (z) are found joint by joint from the ground
/// outwards. Other coordinates are 0.
Eigen::VectorXd initial_guess(const Mechanism& mechanism, double t = 0);

}  // namespace moivre
