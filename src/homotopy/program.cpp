// SPDX-License-Identifier: MIT
// Programs in double and in double-double.
#include "moivre/homotopy/program.h"

#include "moivre/homotopy/write_program.h"

namespace moivre {

template HomotopyProgram<double> make_program(const Homotopy&);
template HomotopyProgram<DoubleDouble> make_program(const Homotopy&);

}  // namespace moivre
