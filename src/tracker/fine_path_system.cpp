// SPDX-License-Identifier: MIT
// Compiled once in double-double.
#include "moivre/tracker/fine_path_system.h"

namespace moivre {

template class FinePathSystem<ComplexDoubleDouble>;

}  // namespace moivre
