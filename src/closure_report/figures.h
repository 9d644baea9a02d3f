// SPDX-License-Identifier: MIT
// What do all drawings build with? Shapes, frames, and a drawing in the making with its layers.
#pragma once

#include <vector>

#include "moivre/closure_report/drawing.h"

namespace moivre {

Shape disc(Style style, Complex centre, double radius);
/// All within `radius` of the segment.
Shape capsule(Style style, Complex from, Complex to, double radius);
Shape polyline(Style style, std::vector<Complex> points);
/// Of the convex hull, which is counter-clockwise and without points on its edges.
Shape rounded_hull(Style style, std::vector<Complex> points, double radius);
/// Half the length along `along` (a unit vector), half the height across it.
Shape rectangle(Style style, Complex centre, Complex along, double half_length, double half_height);

/// Short oblique strokes on the right of the line from `from` to `to`, and the line.
std::vector<Shape> hatched_line(Complex from, Complex to, double size);
/// What holds a joint of radius `size` at z to the ground.
std::vector<Shape> ground_pivot(Complex z, double size);

/// Figures by layer, from back to front, and the frames that they ride on.
struct Sketch {
  enum Layer { backdrop, links, holes, sliders, joints };

  Drawing drawing;
  std::array<std::vector<Figure>, 5> layers;

  std::size_t add(Frame frame);
  void add(Layer layer, std::size_t frame, std::optional<std::size_t> colour,
           std::vector<Shape> shapes);
  Drawing finished() &&;
};

/// Of pins and of marks, in radii of a revolute joint.
inline constexpr double kPinRadius = 0.75;
inline constexpr double kMarkRadius = 0.45;

/// Radius of a revolute joint, for a picture with this extent.
double symbol_size(const Box& extent);

Drawing draw_planar(const Mechanism& mechanism, const std::vector<Eigen::VectorXd>& poses);
Drawing draw_spatial(const Mechanism& mechanism, const std::vector<Eigen::VectorXd>& poses,
                     const View& view);
Drawing draw_unknowns(const Mechanism& mechanism, const std::vector<Eigen::VectorXd>& poses);

/// Groups of points that joints hold together, each with the distinct names of its points: "A", or
/// "A, P".
struct Site {
  std::vector<PointOf> points;
  std::string name;
  bool is_jointed = false;  ///< a joint's symbol stands there
};
std::vector<Site> sites(const Mechanism& mechanism);

/// Whether the file names the joint. Else its name is made of its points', which are written beside
/// them.
bool has_own_name(const Mechanism& mechanism, const Joint& joint);

/// Whether the joint's second point moves along a line or in a plane through its first, so that a
/// line between them is in it.
bool is_guided(const Joint& joint);

/// It turns about a line on which all its points lie, as a forearm does, or the bodies between a
/// wrist's axes.
bool hides_its_turn(const Mechanism& mechanism, std::size_t body);

/// All named points in all poses, as they are seen.
Box extent(const Mechanism& mechanism, const std::vector<Eigen::VectorXd>& poses,
           const Eye& eye = {});

}  // namespace moivre
