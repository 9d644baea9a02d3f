// SPDX-License-Identifier: MIT
// How are poses set side by side on one sheet? Panels of one size, in as many columns as fit, with a heading and a scale bar.
#pragma once

#include <string>
#include <vector>

#include "moivre/closure_report/drawing.h"

namespace moivre {

struct Panel {
  std::string caption;
  Eigen::VectorXd q;
  bool is_faint = false;  ///< no closure
};

struct Sheet {
  std::string title;
  std::string summary;
  std::vector<Panel> panels;  ///< one or more
};

std::string sheet_svg(const Sheet& sheet, const Mechanism& mechanism);

/// Whether it prescribes an angle, or a length.
bool drives_angle(const Mechanism& mechanism, const Driver& driver);

/// "crank = 40 deg, guide = 12 mm": the drivers at this time; empty without drivers.
std::string drivers_text(const Mechanism& mechanism, double time);

/// Pixels per unit of length, so that a joint has a radius of five.
double pixel_scale(const Drawing& drawing);

}  // namespace moivre
