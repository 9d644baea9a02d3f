// SPDX-License-Identifier: MIT
// Sarrus's linkage with bars of one length: the top goes straight up and down, and may be folded
// onto the base.
#pragma once

#include <string>

namespace moivre {

/// Its first bar stands at 45 degrees in the file and is driven by `law`: lines of the [[driver]].
/// It is folded at 45, 135, 225 and 315 degrees.
inline std::string sarrus_text(const std::string& law) {
  return R"toml(space = "spatial"
[units]
angle = "deg"
[ground.points]
A = [1, 0, 0]
D = [0, 1, 0]
[body.l1.points]
A = [1, 0, 0]
B = [2, 0, 1]
[body.l2.points]
B = [2, 0, 1]
C = [1, 0, 2]
[body.top.points]
C = [1, 0, 2]
F = [0, 1, 2]
[body.l3.points]
D = [0, 1, 0]
E = [0, 2, 1]
[body.l4.points]
E = [0, 2, 1]
F = [0, 1, 2]
[[joint]]
type = "revolute"
at = ["ground.A", "l1.A"]
axis = [0, 1, 0]
name = "a"
[[joint]]
type = "revolute"
at = ["l1.B", "l2.B"]
axis = [0, 1, 0]
[[joint]]
type = "revolute"
at = ["l2.C", "top.C"]
axis = [0, 1, 0]
[[joint]]
type = "revolute"
at = ["ground.D", "l3.D"]
axis = [1, 0, 0]
[[joint]]
type = "revolute"
at = ["l3.E", "l4.E"]
axis = [1, 0, 0]
[[joint]]
type = "revolute"
at = ["l4.F", "top.F"]
axis = [1, 0, 0]
[[driver]]
angle = "a"
)toml" + law +
         "\n";
}

}  // namespace moivre
