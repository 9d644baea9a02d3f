// SPDX-License-Identifier: MIT
// What does a mechanism look like? Rigid figures of plain shapes, each on a frame that a pose
// moves.
//
// The plane is C, y upwards, lengths in the file's unit. A pose q gives each frame a similarity z
// -> a z + b, and the figures ride on the frames: SVG, HTML and its animation move the same figures
// and know no joints.
//   planar bodies     a = e^(i phi), b = x + i y
//   rods, actuators   from one point to the other
//   spatial bodies    lines between points, seen by an eye far away
//   typed equations   a dial for each angle, a ruler for each length
// The lengths of guides and slots, and the size of the symbols, follow from all the poses that are
// to be shown.
// Links are drawn as the convex hull of their points. Not drawn: gears and belts whose wheels do
// not turn about points of the carrier.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "moivre/mechanism/mechanism.h"
#include "moivre/numeric/complex.h"

namespace moivre {

/// A place fixed in a body.
struct MaterialPoint {
  std::size_t body = 0;
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
};

/// a = (to - from) / length, b = from; a = 1 where both are one place.
struct LineFrame {
  MaterialPoint from;
  MaterialPoint to;
  double length = 1;
};

/// From one point towards the other, lengths as they are: a = (to - from) / |to - from|, b = from;
/// a = 1 where both are one place.
struct AimFrame {
  MaterialPoint from;
  MaterialPoint to;
};

/// Turns about `center` with coordinate `coordinate` of q.
struct DialFrame {
  Eigen::Index coordinate = 0;
  Complex centre;
};

/// Stands at `zero` + `scale` q[coordinate].
struct RulerFrame {
  Eigen::Index coordinate = 0;
  Complex zero;
  double scale = 1;
};

using Frame = std::variant<LineFrame, AimFrame, DialFrame, RulerFrame>;

enum class Style {
  link,          ///< a body: filled with its colour
  slot,          ///< a hole in a body
  block,         ///< a slider
  pin,           ///< a revolute joint
  slot_pin,      ///< a pin that slides
  weld,          ///< filled black
  rod,           ///< a distance without a body
  wire,          ///< a thick line in the body's colour, of one width whatever the scale
  ground,        ///< a pivot's triangle, a base line
  hatch,         ///< the ground's strokes
  guide,         ///< a line that something slides along
  pitch_circle,  ///< of a gear
  axis,          ///< of a spatial joint, of a ruler
  x_axis,        ///< of a frame that is shown
  y_axis,
  z_axis,
  mark  ///< a point of interest, a tick
};

std::string to_string(Style style);

/// Open: a polyline. Closed: everything within `radius` of the convex polygon `points`,
/// counter-clockwise; one point is a disc, two are a link with round ends.
struct Shape {
  Style style = Style::link;
  std::vector<Complex> points;
  bool is_closed = true;
  double radius = 0;
};

/// Shapes that move as one. `colour`: which of the palette's, by body; nullopt: black and white.
struct Figure {
  std::size_t frame = 0;
  std::optional<std::size_t> colour;
  std::vector<Shape> shapes;
};

enum class LabelKind { body, point, unknown };

/// The class that the style sheet of pictures and pages (document.h) gives to a colour; colours
/// repeat.
std::string colour_class(std::optional<std::size_t> colour);

/// A name beside a place; `coordinate`: followed by its value.
struct Label {
  LabelKind kind = LabelKind::point;
  std::string text;
  std::size_t frame = 0;
  Complex at;
  std::optional<std::size_t> colour;
  std::optional<Eigen::Index> coordinate;
};

/// From where a spatial mechanism is seen, far away. As it is made: in front on the left and above,
/// x goes right, y back, z up.
struct Eye {
  double azimuth_rad = -1.05;
  double elevation_rad = 0.42;
};

/// A frame fixed in a body, shown by lines along its axes.
struct ShownFrame {
  MaterialPoint origin;
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< columns, in the body's frame
  bool is_lettered = false;                            ///< x, y and z are written there
};

/// How a spatial mechanism is to be shown.
struct View {
  Eye eye;
  /// Instead of the ground's alone.
  std::vector<ShownFrame> frames;
  bool has_arrows = false;  ///< joints' axes have heads
  double symbol = 0;        ///< radius of a revolute joint; 0: as fits all the poses
};

struct Drawing {
  std::vector<Frame> frames;
  std::vector<Figure> figures;  ///< from back to front
  std::vector<Label> labels;
  double symbol = 1;     ///< radius of a revolute joint, in the file's unit
  bool to_scale = true;  ///< lengths can be measured in the picture
  Eye eye;
};

/// z -> a z + b.
struct Similarity {
  Complex a = 1;
  Complex b = 0;
  Complex operator()(Complex z) const { return a * z + b; }
};

/// `poses`: all that will be shown, one or more.
Drawing draw(const Mechanism& mechanism, const std::vector<Eigen::VectorXd>& poses,
             const View& view = {});

/// One per frame.
std::vector<Similarity> place(const Drawing& drawing, const Mechanism& mechanism,
                              const Eigen::VectorXd& q);

/// A place in the ground frame, seen in the picture's plane.
Complex seen(const Mechanism& mechanism, const Eigen::Vector3d& r, const Eye& eye = {});

/// The least upright rectangle; empty as it is made.
struct Box {
  Complex lower{1, 1};
  Complex upper{-1, -1};

  bool is_empty() const { return lower.real() > upper.real(); }
  double width() const { return upper.real() - lower.real(); }
  double height() const { return upper.imag() - lower.imag(); }
  /// Takes in the disc about z.
  void include(Complex z, double radius = 0);
};

/// Of all shapes in one pose.
Box bounds(const Drawing& drawing, const std::vector<Similarity>& places);

}  // namespace moivre
