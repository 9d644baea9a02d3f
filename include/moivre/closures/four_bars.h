// SPDX-License-Identifier: MIT
// Which four-bar loops does a mechanism have, and does one of their links turn fully? Grashof's
// rule and Barker's types.
//
// Four links in a loop of four revolutes. Lengths g (frame), a (input), h (coupler), b (output); s,
// l the shortest and the longest of them, p and q the others:
//   s + l < p + q    Grashof: s turns fully, the type says which link it is; two circuits
//   s + l > p + q    no link turns fully, the type says which link is the longest; one circuit
//   s + l = p + q    change point: the links can lie in one line, and circuits meet there
// Frame: the ground; a loop without it has no type. Input: the neighbour of the frame that is
// nearer to a driver, counted in joints; if both are equally near, the first one in the file. A rod
// is a link.
// Edges: lengths that differ by less than 1e-9 of their sum are equal. l > s + p + q: the loop
// cannot be closed.
// Not seen: links of several bodies that are welded together; spatial loops; equations.
// Sources: [Barker85] types and their letters; [McCarthySoh11] signs of the sums.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "moivre/mechanism/mechanism.h"

namespace moivre {

/// Barker's fourteen, and the loop that cannot be closed.
enum class FourBarType {
  double_crank,                ///< GCCC: the frame is shortest
  crank_rocker,                ///< GCRR: the input is
  double_rocker,               ///< GRCR: the coupler is
  rocker_crank,                ///< GRRC: the output is
  triple_rocker_frame,         ///< RRR1: the frame is longest
  triple_rocker_input,         ///< RRR2
  triple_rocker_coupler,       ///< RRR3
  triple_rocker_output,        ///< RRR4
  change_point_double_crank,   ///< SCCC: as the first four, with s + l = p + q
  change_point_crank_rocker,   ///< SCRR
  change_point_double_rocker,  ///< SRCR
  change_point_rocker_crank,   ///< SRRC
  two_equal_pairs,             ///< S2X: parallelogram or kite
  four_equal_sides,            ///< S3X
  cannot_be_closed
};

enum class FourBarRule { grashof, change_point, non_grashof };

/// "crank-rocker".
std::string to_string(FourBarType type);
/// "GCRR"; "" where the loop cannot be closed.
std::string barker_letters(FourBarType type);

/// Lengths g, a, h, b: positive.
FourBarRule four_bar_rule(const std::array<double, 4>& lengths);
FourBarType four_bar_type(const std::array<double, 4>& lengths);

struct FourBar {
  std::array<std::string, 4>
      links;  ///< frame, input, coupler, output; without the ground round the loop
  std::array<double, 4> lengths{};  ///< in the file's unit
  FourBarRule rule = FourBarRule::grashof;
  std::optional<FourBarType> type;  ///< nullopt: the ground is not one of the links
  double shortest_and_longest = 0;  ///< s + l
  double others = 0;                ///< p + q
};

/// Every loop once, in the order of the bodies; none of spatial mechanisms and typed equations.
std::vector<FourBar> four_bars(const Mechanism& mechanism);

}  // namespace moivre
