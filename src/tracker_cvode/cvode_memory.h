// SPDX-License-Identifier: MIT
// Who owns SUNDIALS' objects? Context, vector, nonlinear solver and CVODE memory are freed in the right order.
//
// y: real state of length 2N. Newton's iteration has a dense matrix, 2N x 2N, and its LU as well; the fixed-point iteration
// makes neither. Private to tracker_cvode.
#pragma once

#include <cvode/cvode.h>
#include <cvode/cvode_proj.h>
#include <nvector/nvector_serial.h>
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

class CvodeMemory {
 public:
  CvodeMemory(int linear_multistep_method, CvodeIteration iteration, std::size_t coordinates) {
    require_sundials(SUNContext_Create(nullptr, &context_), "SUNContext_Create");
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
  N_Vector state() const { return state_; }

  /// Hands CVODE, which has been initialized, the solvers of its implicit formulas.
  void attach_solvers() {
    require_sundials(CVodeSetNonlinearSolver(cvode_, solver_), "CVodeSetNonlinearSolver");
    if (linear_solver_ == nullptr) return;
    require_sundials(CVodeSetLinearSolver(cvode_, linear_solver_, matrix_), "CVodeSetLinearSolver");
  }

 private:
  SUNContext context_ = nullptr;
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
