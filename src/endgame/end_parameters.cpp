// SPDX-License-Identifier: MIT
// Which numbers can no end be judged by?
#include "moivre/endgame/end_parameters.h"

namespace moivre {

std::vector<std::string> validate(const EndParameters& ends) {
  std::vector<std::string> broken;
  if (ends.samples < 4 || ends.samples % 2 != 0) {
    broken.push_back("samples must be even and at least 4");
  }
  if (ends.maximum_winding < 1) broken.push_back("maximum_winding must be at least 1");
  if (!(ends.shrink > 1)) broken.push_back("shrink must be above 1");
  return broken;
}

}  // namespace moivre
