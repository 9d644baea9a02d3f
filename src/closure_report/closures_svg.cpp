// SPDX-License-Identifier: MIT
// The closures' picture: panels in rows, of one size and one scale.

#include "labels.h"
#include "moivre/closure_report/closure_report.h"
#include "moivre/closure_report/sheet.h"
#include "moivre/report/number_text.h"
#include "pose_text.h"
#include "svg.h"

namespace moivre {
namespace {

std::string caption(const Closure& closure) {
  if (closure.multiplicity > 1) return closure.id + ": singular, " + multiplicity_text(closure);
  if (closure.is_fitted) return closure.id + ": misfit " + short_text(closure.misfit);
  return closure.id + (closure.singular ? ": singular" : "");
}

std::string summary(const ClosureResult& result, const Mechanism& mechanism) {
  std::string text = counts_text(result.counts);
  if (result.counts.filtered > 0) {
    text += " (" + std::to_string(result.counts.filtered) + " outside a joint's limits)";
  }
  text += fitted_text(result.counts);
  const std::string drivers = drivers_text(mechanism, result.time);
  if (!drivers.empty()) text += "; " + drivers;
  if (result.time != 0) text += ", t = " + short_text(result.time) + " s";
  if (!result.complete || result.moves || result.closures.empty()) text += "; " + result.message;
  return text;
}

}  // namespace

std::string closures_svg(const ClosureResult& result, const Mechanism& mechanism,
                         const std::string& file, Views views) {
  Sheet sheet;
  sheet.views = views;
  sheet.title = picture_title(mechanism, file);
  sheet.summary = summary(result, mechanism);
  for (const Closure& closure : result.closures) {
    sheet.panels.push_back({caption(closure), closure.q});
  }
  if (sheet.panels.empty()) {
    sheet.panels.push_back(
        {"no closure: the initial guess", initial_guess(mechanism, result.time), true});
  }
  return sheet_svg(sheet, mechanism);
}

}  // namespace moivre
