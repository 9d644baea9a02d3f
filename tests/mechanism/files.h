// SPDX-License-Identifier: MIT
// Which mechanisms do the tests read? Those of problems/mechanisms, and texts.
#pragma once

#include <string>

#include "moivre/mechanism/phi.h"
#include "moivre/mechanism/read.h"

namespace moivre::test {

inline Mechanism example(const std::string& name) {
  return read_mechanism(
      read_source(std::string(MOIVRE_SOURCE_DIR) + "/problems/mechanisms/" + name + ".toml"));
}

inline Mechanism typed(const std::string& text) {
  return read_mechanism(Source{"typed.toml", text});
}

/// Three rods of one length from points of the ground, typed "[0, 0] [2, 0] [5, 0]", to the same of
/// a body: in line they let it move on a circle without turning.
inline std::string collinear_rods_text(const std::string& points, double length) {
  std::string ground = "[ground.points]\n";
  std::string body = "[body.p.points]\n";
  std::string rods;
  std::size_t begin = 0;
  for (const char* const name : {"0", "1", "2"}) {
    const std::size_t end = points.find(']', begin) + 1;
    const std::string point = points.substr(begin, end - begin);
    begin = end + 1;
    ground += std::string("A") + name + " = " + point + '\n';
    body += std::string("B") + name + " = " + point + '\n';
    rods += std::string("[[joint]]\ntype = \"rod\"\nat = [\"ground.A") + name + "\", \"p.B" + name +
            "\"]\nlength = " + std::to_string(length) + '\n';
  }
  return ground + body + rods;
}

inline Mechanism collinear_rods(const std::string& points, double length) {
  return typed(collinear_rods_text(points, length));
}

/// Links of 2 and 1 on pivots `base` apart, pinned at their tips: from 1 to 3 a triangle, there and
/// at 1 folded.
inline std::string triangle_text(const std::string& base) {
  return "[ground.points]\nO = [0, 0]\nP = [" + base + R"toml(, 0]
[body.left.points]
O = [0, 0]
A = [2, 0]
[body.right.points]
P = [0, 0]
A = [-1, 0]
[[joint]]
type = "revolute"
at = ["ground.O", "left.O"]
[[joint]]
type = "revolute"
at = ["ground.P", "right.P"]
[[joint]]
type = "revolute"
at = ["left.A", "right.A"]
)toml";
}

/// Two links of 1 between a pivot and a slider at a distance that `value` gives: stretched out
/// where that is 2.
inline std::string toggle_text(const std::string& value) {
  return R"toml(
[ground.points]
G = [0, 0]
[body.a.points]
G = [0, 0]
M = [1, 0]
[body.b.points]
M = [0, 0]
S = [1, 0]
[body.slider.points]
S = [0, 0]
[[joint]]
type = "revolute"
at = ["ground.G", "a.G"]
[[joint]]
type = "revolute"
at = ["a.M", "b.M"]
[[joint]]
type = "revolute"
at = ["b.S", "slider.S"]
[[joint]]
type = "prismatic"
at = ["ground.G", "slider.S"]
along = [1, 0]
name = "guide"
[[driver]]
slide = "guide"
value = ")toml" +
         value + "\"\n";
}

/// A crank, a rod and a slider whose line, through G, passes `offset` above the crank's pivot; the
/// slide is `guide`. Drivers are to be added.
inline std::string slider_crank_links(double crank, double rod, double offset) {
  const auto text = [](double x) { return std::to_string(x); };
  return "[ground.points]\nO = [0, 0]\nG = [0, " + text(offset) +
         "]\n[body.crank.points]\nO = [0, 0]\nA = [" + text(crank) +
         ", 0]\n[body.rod.points]\nA = [0, 0]\nB = [" + text(rod) + R"toml(, 0]
[body.slider.points]
B = [0, 0]
[[joint]]
type = "revolute"
at = ["ground.O", "crank.O"]
[[joint]]
type = "revolute"
at = ["crank.A", "rod.A"]
[[joint]]
type = "revolute"
at = ["rod.B", "slider.B"]
[[joint]]
type = "prismatic"
at = ["ground.G", "slider.B"]
along = [1, 0]
name = "guide"
)toml";
}

/// A crank at 50 degrees and a rocker about a skew axis; the link between them turns about its two
/// balls, and nothing depends on that.
inline constexpr const char* kSpinningCoupler = R"toml(space = "spatial"
[ground.points]
O2 = [0, 0, 0]
O4 = [4, 1, 0.5]
[body.crank.points]
O2 = [0, 0, 0]
A  = [1.2, 0, 0.3]
[body.coupler.points]
A = [0, 0, 0]
B = [4, 0, 0]
[body.rocker.points]
O4 = [0, 0, 0]
B  = [2.5, 0, 0]
[[joint]]
type = "revolute"
at = ["ground.O2", "crank.O2"]
axis = [0, 0, 1]
name = "input"
[[joint]]
type = "revolute"
at = ["ground.O4", "rocker.O4"]
axis = [[0, 0.6, 0.8], [0, 0, 1]]
name = "output"
[[joint]]
type = "spherical"
at = ["crank.A", "coupler.A"]
[[joint]]
type = "spherical"
at = ["coupler.B", "rocker.B"]
[[driver]]
angle = "input"
start = 0.8726646259971648
)toml";

inline constexpr double kDegree = 0.017453292519943295769;

}  // namespace moivre::test
