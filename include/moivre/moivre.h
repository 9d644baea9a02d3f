// SPDX-License-Identifier: MIT
// What does an outsider need? All of it by one header: systems, roots, families, mechanisms,
// closures, motions, arms, reports.
//
// It names every header that is installed, and no other (decision 100). Of what was left out when
// Moivre was configured the headers are not there, and are not included.
// docs/library.md shows their use.
// Every call refuses what cannot be meant by one exception (numeric/invalid_input.h).
#pragma once

#include "moivre/expression/source.h"
#include "moivre/numeric/complex.h"
#include "moivre/numeric/invalid_input.h"
#include "moivre/numeric/rational.h"
#include "moivre/polynomial/coordinate_planes.h"
#include "moivre/polynomial/read.h"
#include "moivre/polynomial/system.h"
#include "moivre/version.h"

#if __has_include("moivre/tracker/tracker.h")
#include "moivre/tracker/tracker.h"
#include "moivre/tracker/tracker_options.h"
#endif
#if __has_include("moivre/tracker_cvode/cvode_tracker.h")
#include "moivre/tracker_cvode/cvode_tracker.h"
#endif
#if __has_include("moivre/tracker_lanes/lane_tracker.h")
#include "moivre/tracker_lanes/lane_tracker.h"
#endif

#if __has_include("moivre/solver/solve.h")
#include "moivre/endgame/end_parameters.h"
#include "moivre/solver/cross_check.h"
#include "moivre/solver/digits.h"
#include "moivre/solver/filter.h"
#include "moivre/solver/solve.h"
#include "moivre/start/start_kind.h"
#endif
#if __has_include("moivre/bounds/root_bounds.h")
#include "moivre/bounds/root_bounds.h"
#endif
#if __has_include("moivre/report/solve_report.h")
#include "moivre/report/solve_report.h"
#include "moivre/report/text_sink.h"
#endif

#if __has_include("moivre/family/family.h")
#include "moivre/family/book.h"
#include "moivre/family/family.h"
#include "moivre/family/family_file.h"
#include "moivre/family/learn.h"
#include "moivre/family/members.h"
#include "moivre/family/parameter_homotopy.h"
#endif

#if __has_include("moivre/mechanism/mechanism.h")
#include "moivre/expression/expression.h"
#include "moivre/mechanism/builder.h"
#include "moivre/mechanism/dimensions.h"
#include "moivre/mechanism/driver_law.h"
#include "moivre/mechanism/formula.h"
#include "moivre/mechanism/mechanism.h"
#include "moivre/mechanism/phi.h"
#include "moivre/mechanism/pose.h"
#include "moivre/mechanism/read.h"
#include "moivre/mechanism/rules.h"
#endif
#if __has_include("moivre/kinematics/newton.h")
#include "moivre/kinematics/branch.h"
#include "moivre/kinematics/linear.h"
#include "moivre/kinematics/mobility.h"
#include "moivre/kinematics/newton.h"
#include "moivre/kinematics/own_newton.h"
#endif
#if __has_include("moivre/closures/closures.h")
#include "moivre/closures/closures.h"
#include "moivre/closures/guesses.h"
#endif
#if __has_include("moivre/motion/motion.h")
#include "moivre/motion/circuits.h"
#include "moivre/motion/motion.h"
#endif
#if __has_include("moivre/design/sensitivity.h")
#include "moivre/design/readings.h"
#include "moivre/design/sensitivity.h"
#endif
#if __has_include("moivre/sweep/sweep.h")
#include "moivre/sweep/sweep.h"
#endif
#if __has_include("moivre/closure_report/closure_report.h")
#include "moivre/closure_report/closure_report.h"
#include "moivre/closure_report/motion_report.h"
#endif

#if __has_include("moivre/arms/arm_closures.h")
#include "moivre/arms/arm.h"
#include "moivre/arms/arm_closures.h"
#include "moivre/arms/held_range.h"
#include "moivre/arms/pose_table.h"
#include "moivre/arms/poses.h"
#include "moivre/arms/posture.h"
#include "moivre/urdf/read.h"
#include "moivre/urdf/robot.h"
#endif
