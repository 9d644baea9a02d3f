// SPDX-License-Identifier: MIT
// How is a pose written down in JSON? Coordinates by name, bodies, points; and what a mechanism's
// mobility is.
#pragma once

#include "moivre/closures/closures.h"
#include "moivre/mechanism/mechanism.h"
#include "moivre/report/json.h"

namespace moivre {

/// As refill of json.h.
void refill(Json& tree, const Eigen::VectorXd& numbers);

/// {"crank.phi": null, ...}: to be filled with q.
Json coordinates_form(const Mechanism& mechanism);

/// Poses of one mechanism, one after another: names are made once, numbers for each pose.
class PoseJson {
 public:
  /// `mechanism` must outlive it.
  explicit PoseJson(const Mechanism& mechanism);
  /// {"coordinates": {"crank.phi": 0.52, ...}, "bodies": {"crank": {"x":.., "y":.., "phi":..},
  /// ...}, "points": {"crank.B": [x, y], ...}}, of every point of a moving body; the last two are
  /// {} for typed equations. It stands until the next pose is read.
  const Json& read(const Eigen::VectorXd& q);

 private:
  const Mechanism& mechanism_;
  Json pose_;
};

/// {"crank.phi": 0.52, ...}.
Json coordinates_json(const Mechanism& mechanism, const Eigen::VectorXd& q);

/// {"body": .., "joint": .., "held": ..}
Json idle_json(const std::vector<IdleJoint>& idle);

/// What the reports of closures and of a motion begin with, behind report_head() of json.h: "seed",
/// "complete", "message", "title", "idle", "warnings".
template <class Result>
Json result_head(const std::string& command, const std::string& file, const Result& result,
                 const Mechanism& mechanism) {
  Json head = report_head(command, file);
  head["seed"] = result.seed;
  head["complete"] = result.complete;
  head["message"] = result.message;
  head["title"] = mechanism.title;
  head["idle"] = idle_json(result.idle);
  head["warnings"] = mechanism.warnings;
  return head;
}

Json to_json(const Eigen::VectorXd& v);
/// Row by row.
Json rows_json(const Eigen::MatrixXd& m);
/// {"length": "mm", "angle": "rad"}: of what JSON has, whatever the file was written in; null where
/// it names no length.
Json units_json(const Mechanism& mechanism);

}  // namespace moivre
