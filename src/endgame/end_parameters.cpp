// SPDX-License-Identifier: MIT
// Which numbers can no end be judged by?
#include "moivre/endgame/end_parameters.h"

#include <cmath>

#include "moivre/numeric/positive.h"

namespace moivre {

std::vector<std::string> validate(const EndParameters& ends) {
  std::vector<std::string> broken = not_positive({{"watch_radius", ends.watch_radius},
                                                  {"creeping_radius", ends.creeping_radius},
                                                  {"first_radius", ends.first_radius},
                                                  {"least_radius", ends.least_radius},
                                                  {"rounding", ends.rounding},
                                                  {"sample_error", ends.sample_error},
                                                  {"agreement", ends.agreement},
                                                  {"regular_condition", ends.regular_condition},
                                                  {"singular_condition", ends.singular_condition},
                                                  {"zero_sum", ends.zero_sum},
                                                  {"beyond", ends.beyond},
                                                  {"known_size", ends.known_size},
                                                  {"valuation_error", ends.valuation_error},
                                                  {"face_threshold", ends.face_threshold},
                                                  {"face_progress", ends.face_progress},
                                                  {"fine_rounding", ends.fine_rounding}});
  if (ends.samples < 4 || ends.samples % 2 != 0) {
    broken.push_back("samples must be even and at least 4");
  }
  if (ends.maximum_winding < 1) broken.push_back("maximum_winding must be at least 1");
  if (!(ends.shrink > 1) || !std::isfinite(ends.shrink)) {
    broken.push_back("shrink must be finite and above 1");
  }
  return broken;
}

}  // namespace moivre
