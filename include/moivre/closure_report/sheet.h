// SPDX-License-Identifier: MIT
// How are poses of one mechanism shown side by side, however they were computed? Panels on a sheet,
// or on a page that turns them.
//
// A panel is a pose q of the mechanism (mechanism/mechanism.h) with a caption and lines of text.
// All have one scale and the ground at the same place. A spatial mechanism is seen from one place,
// or each panel comes three times: from the front, from the right and from above, as in an
// engineering drawing. Names are escaped: whatever they hold, the document stays well-formed.
#pragma once

#include <string>
#include <vector>

#include "moivre/closure_report/closure_report.h"
#include "moivre/closure_report/drawing.h"

namespace moivre {

struct Panel {
  std::string caption;
  Eigen::VectorXd q;
  bool is_faint = false;                ///< no closure
  std::vector<std::string> notes = {};  ///< below the caption
};

struct Sheet {
  std::string title;
  std::string summary;
  std::vector<Panel> panels;  ///< one or more
  View view = {};
  Views views = Views::standing;
};

/// The mechanism's title; where it has none, the file's name without its folder.
std::string picture_title(const Mechanism& mechanism, const std::string& file);

/// Throws std::invalid_argument, with the reason, where it has but one view.
void require_spatial(const Mechanism& mechanism);

/// In as many columns as fit, with a heading and a scale bar.
std::string sheet_svg(const Sheet& sheet, const Mechanism& mechanism);

/// Of a spatial mechanism: one page, whose poses the mouse turns together.
std::string turning_html(const Sheet& sheet, const Mechanism& mechanism);

}  // namespace moivre
