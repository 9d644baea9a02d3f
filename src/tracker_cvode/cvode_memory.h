// SPDX-License-Identifier: MIT
// SUNDIALS objects with owners: context, vector, fixed-point solver and CVODE memory, freed in the right order.
//
// y: real state of length 2N. Private to tracker_cvode.
#pragma once

#include <cvode/cvode.h>
#include <cvode/cvode_proj.h>
#include <nvector/nvector_serial.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <span>
#include <stdexcept>
#include <string>

#include "moivre/numeric/complex.h"

namespace moivre {

/// A failure while CVODE is set up is a fault of ours or of memory, never of the mathematics.
inline void require_sundials(int flag, const char* call) {
  if (flag < 0) throw std::runtime_error(std::string(call) + " failed: " + std::to_string(flag));
}

class CvodeMemory {
 public:
  CvodeMemory(int linear_multistep_method, std::size_t coordinates) {
    require_sundials(SUNContext_Create(nullptr, &context_), "SUNContext_Create");
    state_ = N_VNew_Serial(static_cast<sunindextype>(2 * coordinates), context_);
    solver_ = SUNNonlinSol_FixedPoint(state_, 0, context_);
    cvode_ = CVodeCreate(linear_multistep_method, context_);
    if (state_ == nullptr || solver_ == nullptr || cvode_ == nullptr) {
      throw std::runtime_error("SUNDIALS could not be set up");
    }
  }
  ~CvodeMemory() {
    CVodeFree(&cvode_);
    SUNNonlinSolFree(solver_);
    N_VDestroy(state_);
    SUNContext_Free(&context_);
  }
  CvodeMemory(const CvodeMemory&) = delete;
  CvodeMemory& operator=(const CvodeMemory&) = delete;

  void* cvode() const { return cvode_; }
  N_Vector state() const { return state_; }
  SUNNonlinearSolver solver() const { return solver_; }

 private:
  SUNContext context_ = nullptr;
  N_Vector state_ = nullptr;
  SUNNonlinearSolver solver_ = nullptr;
  void* cvode_ = nullptr;
};

/// The complex coordinates that a real state holds.
inline std::span<Complex> coordinates(N_Vector y) {
  return {reinterpret_cast<Complex*>(N_VGetArrayPointer(y)),
          static_cast<std::size_t>(N_VGetLength(y)) / 2};
}

}  // namespace moivre
