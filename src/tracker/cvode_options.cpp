// SPDX-License-Identifier: MIT
// The table of CVODE's options.
#include "moivre/tracker/option_table.h"
#include "moivre/tracker/tracker_options.h"

namespace moivre {

std::string to_string(CvodeMethod method) {
  switch (method) {
    case CvodeMethod::bdf_projection:
      return "bdf_projection";
    case CvodeMethod::bdf:
      return "bdf";
    case CvodeMethod::adams:
      return "adams";
  }
  return "";
}

std::string to_string(CvodeIteration iteration) {
  switch (iteration) {
    case CvodeIteration::fixed_point:
      return "fixed_point";
    case CvodeIteration::newton:
      return "newton";
  }
  return "";
}

const OptionTable<CvodeOptions>& cvode_table() {
  using O = CvodeOptions;
  static const OptionTable<O> kTable{
      word_row(
          {.name = "method",
           .flag = "--method",
           .sentence = "bdf_projection, bdf or adams",
           .plural = "methods",
           .absent =
               {{"adams_projection",
                 "CVODE projects with BDF only (\"CVodeSetProjFn: projection is only supported "
                 "with BDF\"); take bdf_projection, or adams without projection"}}},
          &O::method, {CvodeMethod::bdf_projection, CvodeMethod::bdf, CvodeMethod::adams}),
      word_row({.name = "iteration",
                .flag = "--iteration",
                .sentence = "fixed_point, or newton with a Jacobian by difference quotients",
                .plural = "iterations"},
               &O::iteration, {CvodeIteration::fixed_point, CvodeIteration::newton}),
      number_row<O, double>({.name = "rtol",
                             .flag = "--rtol",
                             .sentence = "relative local error of a step",
                             .range = "must lie in (0, 0.5]"},
                            &O::rtol, [](double rtol) { return rtol > 0 && rtol <= 0.5; }),
      steps_row<O>()};
  return kTable;
}

std::vector<std::string> validate(const CvodeOptions& options) {
  return broken_rules(cvode_table(), options);
}

}  // namespace moivre
