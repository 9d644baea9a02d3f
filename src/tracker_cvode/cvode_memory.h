// SPDX-License-Identifier: MIT
// Who owns SUNDIALS' objects? Context, vector, nonlinear solver and CVODE memory are freed in the
// right order.
//
// What differs between SUNDIALS 6.4 and 7 stands here: how a context is made without MPI, and how
// errors are kept from the terminal.
// y: real state of length 2N. Newton's iteration has a dense matrix, 2N x 2N, and its LU as well;
// the fixed-point iteration makes neither. Private to tracker_cvode.
#pragma once

#include <cvode/cvode.h>
#include <cvode/cvode_proj.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_config.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>
#include <sunnonlinsol/sunnonlinsol_newton.h>

#include <span>
#include <stdexcept>
#include <string>

#include "moivre/numeric/complex.h"
#include "moivre/tracker_cvode/cvode_tracker.h"

namespace moivre {

/// A failure while CVODE is set up is a fault of ours or of memory, never of the mathematics.
inline void require_sundials(int flag, const char* call) {
  if (flag < 0) throw std::runtime_error(std::string(call) + " failed: " + std::to_string(flag));
}

#if SUNDIALS_VERSION_MAJOR < 7
inline SUNContext make_context() {
  SUNContext context = nullptr;
  require_sundials(SUNContext_Create(nullptr, &context), "SUNContext_Create");
  return context;
}
#else
inline SUNContext make_context() {
  SUNContext context = nullptr;
  require_sundials(SUNContext_Create(SUN_COMM_NULL, &context), "SUNContext_Create");
  require_sundials(SUNContext_ClearErrHandlers(context), "SUNContext_ClearErrHandlers");
  require_sundials(SUNContext_SetLogger(context, nullptr), "SUNContext_SetLogger");
  return context;
}
#endif

class CvodeMemory {
 public:
  CvodeMemory(int linear_multistep_method, CvodeIteration iteration, std::size_t coordinates) {
    const auto size = static_cast<sunindextype>(2 * coordinates);
    state_ = N_VNew_Serial(size, context_);
    cvode_ = CVodeCreate(linear_multistep_method, context_);
    if (iteration == CvodeIteration::newton) {
      solver_ = SUNNonlinSol_Newton(state_, context_);
      matrix_ = SUNDenseMatrix(size, size, context_);
      linear_solver_ = SUNLinSol_Dense(state_, matrix_, context_);
    } else {
      solver_ = SUNNonlinSol_FixedPoint(state_, 0, context_);
    }
    const bool has_all = iteration == CvodeIteration::fixed_point || linear_solver_ != nullptr;
    if (state_ == nullptr || solver_ == nullptr || cvode_ == nullptr || !has_all) {
      throw std::runtime_error("SUNDIALS could not be set up");
    }
  }
  ~CvodeMemory() {
    CVodeFree(&cvode_);
    SUNNonlinSolFree(solver_);
    if (linear_solver_ != nullptr) SUNLinSolFree(linear_solver_);
    if (matrix_ != nullptr) SUNMatDestroy(matrix_);
    N_VDestroy(state_);
    SUNContext_Free(&context_);
  }
  CvodeMemory(const CvodeMemory&) = delete;
  CvodeMemory& operator=(const CvodeMemory&) = delete;

  void* cvode() const { return cvode_; }
  /// A failure is an outcome, and told by a flag; nothing is printed.
  void silence() {
#if SUNDIALS_VERSION_MAJOR < 7
    const auto nothing = [](int, const char*, const char*, char*, void*) {};
    require_sundials(CVodeSetErrHandlerFn(cvode_, nothing, nullptr), "CVodeSetErrHandlerFn");
#endif
  }
  N_Vector state() const { return state_; }

  /// Hands CVODE, which has been initialized, the solvers of its implicit formulas.
  void attach_solvers() {
    require_sundials(CVodeSetNonlinearSolver(cvode_, solver_), "CVodeSetNonlinearSolver");
    if (linear_solver_ == nullptr) return;
    require_sundials(CVodeSetLinearSolver(cvode_, linear_solver_, matrix_), "CVodeSetLinearSolver");
  }

 private:
  SUNContext context_ = make_context();
  N_Vector state_ = nullptr;
  SUNNonlinearSolver solver_ = nullptr;
  SUNMatrix matrix_ = nullptr;
  SUNLinearSolver linear_solver_ = nullptr;
  void* cvode_ = nullptr;
};

/// The complex coordinates that a real state holds.
inline std::span<Complex> coordinates(N_Vector y) {
  return {reinterpret_cast<Complex*>(N_VGetArrayPointer(y)),
          static_cast<std::size_t>(N_VGetLength(y)) / 2};
}

}  // namespace moivre
