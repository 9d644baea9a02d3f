// SPDX-License-Identifier: MIT
// The table of the lanes' options.
#include "moivre/tracker/option_table.h"
#include "moivre/tracker/tracker_options.h"

namespace moivre {

std::string to_string(LanePredictor predictor) {
  switch (predictor) {
    case LanePredictor::tangent:
      return "tangent";
    case LanePredictor::cubic:
      return "cubic";
    case LanePredictor::quintic:
      return "quintic";
  }
  return "";
}

int order_of(LanePredictor predictor) {
  switch (predictor) {
    case LanePredictor::tangent:
      return 2;
    case LanePredictor::cubic:
      return 4;
    case LanePredictor::quintic:
      return 6;
  }
  return 0;
}

const OptionTable<LaneOptions>& lane_table() {
  using O = LaneOptions;
  static const OptionTable<O> kTable{
      word_row({.name = "predictor",
                .flag = "--predictor",
                .sentence =
                    "tangent, cubic or quintic, from one, two or three points and their tangents",
                .plural = "predictors"},
               &O::predictor,
               {LanePredictor::tangent, LanePredictor::cubic, LanePredictor::quintic}),
      number_row<O, double>(
          {.name = "tolerance",
           .flag = "--tolerance",
           .sentence = "target for the relative size of a step's first Newton correction",
           .range = "must lie in (0, 0.1]"},
          &O::tolerance, [](double tolerance) { return tolerance > 0 && tolerance <= 0.1; }),
      steps_row<O>()};
  return kTable;
}

std::vector<std::string> validate(const LaneOptions& options) {
  return broken_rules(lane_table(), options);
}

}  // namespace moivre
