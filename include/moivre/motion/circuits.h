// SPDX-License-Identifier: MIT
// Which closures can be reached from which without taking the mechanism apart? The branches of a
// motion, joined to circuits.
//
// A circuit is a connected piece of the curve of assembled poses over the drivers' range
// [ChaseMirth93]. Its parts are the branches of a motion (motion.h). Their ends are joined
//   at a dead point     two branches meet: the driver turns back there, the mechanism goes on
//   at a bifurcation    branches cross: a change point
//   after a full turn   the drivers at `to` are as at `from`: a branch continues in the one that
//                       begins with its last pose
// Two closures on different circuits are a circuit defect. Two on one circuit with a dead point
// between are a branch defect.
// A stretch is a part of a circuit without a dead point. It is the "branch" of [ChaseMirth93],
// which is not cut where a motion happens to begin.
//
// Angles are continuous along a branch, and over a join up to whole turns. Around every closed loop
// of a circuit an angle either returns to its value, then it rocks and has a range, or it changes
// by whole turns, then it turns.
// Ranges are those of the curves, to about 1e-7, and do not depend on the number of samples.
// Symbols: angles in radians, lengths in the file's unit.
// Edges: if the drivers do not return, as over half a turn, circuits may be joined outside of the
// range (`notes`).
// Not seen: that a driver which turns back passes its poses again; all joins of a dead point at
// `from` itself.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "moivre/motion/motion.h"

namespace moivre {

enum class JoinKind { turn, dead_point, bifurcation };

/// The end or the beginning of a branch.
struct BranchEnd {
  std::size_t branch = 0;  ///< index into MotionResult::branches
  bool is_last = false;    ///< its end
};

/// Two ends that are one place.
struct BranchJoin {
  JoinKind kind = JoinKind::turn;
  std::array<BranchEnd, 2> ends;
};

/// How far an angle or a slide moves on a circuit.
struct Swing {
  std::string name;  ///< of the driver, the body (or unknown) or the joint
  CoordinateKind kind = CoordinateKind::angle;
  int turns = 0;     ///< whole turns once round the circuit; 0: it rocks
  double lower = 0;  ///< where it does not turn; of an angle in (-pi, pi], of a driver in [0, 2 pi)
  double upper = 0;
};

enum class DriverMotion {
  turns,                   ///< fully, without a dead point
  turns_over_dead_points,  ///< only another link could turn it fully
  rocks,                   ///< between dead points or stops
  open                     ///< to the end of the given range
};

/// "turns", "turns over dead points", "rocks", "open".
std::string to_string(DriverMotion motion);

struct Circuit {
  std::vector<std::size_t> branches;                ///< indices into MotionResult::branches
  std::vector<std::vector<std::size_t>> stretches;  ///< of these, each in the driver's order
  DriverMotion driver_motion = DriverMotion::open;  ///< of the first driver
  std::vector<Swing> drivers;                       ///< in the order of Mechanism::drivers
  std::vector<Swing> bodies;  ///< planar: each moving body; typed equations: each unknown
  std::vector<Swing> joints;  ///< relative angles of revolutes between moving bodies, slides
  std::vector<std::size_t> dead_points;    ///< indices into MotionResult::events
  std::vector<std::size_t> change_points;  ///< likewise, bifurcations
  std::vector<std::size_t> stops;          ///< likewise, joint limits
};

struct Circuits {
  bool is_full_turn =
      false;  ///< the range is one turn of the drivers, so that nothing lies outside
  std::vector<Circuit> circuits;  ///< by their first branch
  std::vector<BranchJoin> joins;
  std::vector<std::string> notes;  ///< what leaves circuits open, each a sentence
};

/// Throws std::invalid_argument where the motion is not one of this mechanism.
Circuits find_circuits(const Mechanism& mechanism, const MotionResult& motion);

/// The circuit of the branch: an index into Circuits::circuits.
std::size_t circuit_of(const Circuits& circuits, std::size_t branch);

/// What must be passed between one branch and another.
struct Passage {
  int dead_points = 0;    ///< as few as can be
  int change_points = 0;  ///< then likewise
};

/// From a branch to every branch; nullopt: they lie on different circuits.
std::vector<std::optional<Passage>> passages_from(const Circuits& circuits, std::size_t branch);

/// The branches that are there at MotionResult::from, as indices: its closures, by their names.
std::vector<std::size_t> first_branches(const MotionResult& motion);

/// The motion with only those branches that can be reached from these closures at `from`.
/// Checkpoints do not change.
/// A closure is named by its id, "drawn" is the one that was drawn; of independent sub-chains E.H
/// has one of each, and 1:E is any with E of the first one.
/// Throws std::invalid_argument, which lists the closures, if one does not exist.
MotionResult reachable_from(MotionResult motion, const Circuits& circuits,
                            const std::vector<std::string>& closures);

}  // namespace moivre
