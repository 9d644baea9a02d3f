// SPDX-License-Identifier: MIT
// How does a trusted integrator follow a path? SUNDIALS CVODE on J x' = [-H_t dt/ds; 0], with a
// Newton projection.
//
//   y: real state of 2N (real and imaginary parts in turn), s: contour parameter, as independent
//   variable method bdf_projection: variable-order BDF, and after every step CVODE's projection
//   call puts y
//     back on H(y, t(s)) = 0 by Newton's method; a step from which Newton does not contract is
//     taken again, shorter
//   method bdf, adams: the integrator alone (Newton only at the end), to compare. CVODE refuses a
//   projection with Adams
//     ("CVodeSetProjFn: projection is only supported with BDF"), so there is no adams_projection.
//   iteration fixed_point: the implicit formula of each step is solved by substitution, two
//   right-hand sides or so iteration newton: by modified Newton, d x'/d x dense and by difference
//   quotients: 2N right-hand sides, each with a
//     factorization, whenever CVODE renews it. For paths that are stiff, where substitution does
//     not contract.
//
// The loose default tolerance is enough because Newton corrects every step: docs/decisions has the
// measurements.
// Weights are relative per complex coordinate, with the floor of tracker/path_system.h.
// Edges: no SUNDIALS type leaves the module; one CVODE memory per session. Not supported: sparse or
// iterative linear solvers.
// Source: [SUNDIALS], [EichCvodeProjection93] for integrating with coordinate projection.
#pragma once

#include <memory>

#include "moivre/tracker/tracker.h"
#include "moivre/tracker/tracker_options.h"

namespace moivre {

/// Throws std::invalid_argument with all sentences of validate().
std::unique_ptr<Tracker> make_cvode_tracker(const CvodeOptions& options = {});

}  // namespace moivre
