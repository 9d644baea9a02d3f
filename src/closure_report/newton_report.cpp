// SPDX-License-Identifier: MIT
// A Newton run: the verdict, the table of iterates, the pose.
#include <algorithm>
#include <cstdio>

#include "moivre/closure_report/kinematics_report.h"
#include "moivre/report/number_text.h"
#include "pose_json.h"
#include "pose_text.h"

namespace moivre {
namespace {

// Up to so many coordinates stand in the table itself; of more the CSV has them.
constexpr std::size_t kColumns = 6;

std::string column(std::string text) {
  constexpr std::size_t kWidth = 14;
  text.insert(0, 2, ' ');
  text.resize(std::max(text.size(), kWidth + 2), ' ');
  return text;
}

std::string line_of(std::string text) {
  text.erase(text.find_last_not_of(' ') + 1);
  return text + '\n';
}

std::string table(const NewtonResult& result, const Mechanism& mechanism) {
  const std::vector<Coordinate> names = coordinates(mechanism);
  const bool shows_q = names.size() <= kColumns;
  std::string head = "  k  residual  step      rank  method      ";
  for (const Coordinate& name : names) head += shows_q ? column(name.name) : "";
  std::string text(1, '\n');
  text += line_of(head);
  std::size_t k = 0;
  for (const NewtonIteration& iteration : result.iterations) {
    char figures[96];
    std::snprintf(figures, sizeof figures, "%3zu  %-8s  %-8s  %4td  %-12s", k++,
                  rough_text(iteration.residual).c_str(), rough_text(iteration.step).c_str(),
                  iteration.rank, to_string(iteration.method).c_str());
    std::string line = figures;
    for (std::size_t c = 0; shows_q && c < names.size(); ++c) {
      const double value = iteration.q[static_cast<Eigen::Index>(c)];
      line += column(coordinate_text(mechanism, names[c], value));
    }
    text += line_of(line);
  }
  return text;
}

/// The status and how it came about; a message that begins with the status says it once.
std::string verdict(const NewtonResult& result) {
  const std::string status = to_string(result.status);
  return result.message.starts_with(status) ? result.message : status + ": " + result.message;
}

Json iteration_json(const NewtonIteration& iteration) {
  return {{"q", to_json(iteration.q)},
          {"residual", to_json(iteration.residual)},
          {"scaled_residual", to_json(iteration.scaled_residual)},
          {"step", to_json(iteration.step)},
          {"rank", iteration.rank},
          {"method", to_string(iteration.method)}};
}

/// Where the run ended, as a closure is told: it may have gone round and round.
Eigen::VectorXd end_of(const NewtonResult& result, const Mechanism& mechanism) {
  return result.q.allFinite() ? Phi(mechanism).canonical(result.q) : result.q;
}

}  // namespace

std::string newton_text(const NewtonResult& result, const Mechanism& mechanism,
                        const KinematicsHeading& heading) {
  std::string text = (mechanism.title.empty() ? "" : mechanism.title + " ") + "(" + heading.file +
                     ")\n" + warnings_text(mechanism) + verdict(result) + '\n';
  if (result.status != NewtonStatus::converged) {
    text += "'moivre guesses' gives a start near every solution\n";
  }
  text += table(result, mechanism);
  const std::string& unit = mechanism.units.length;
  text += "\nresidual " + rough_text(result.residual) + ", misfit " +
          rough_text(misfit(Phi(mechanism), result.q, heading.time)) +
          (unit.empty() ? "" : " " + unit) + ", smallest singular value " +
          rough_text(result.smallest_singular_value) + ", condition " +
          rough_text(result.condition) + (result.is_singular ? ", singular" : "") + '\n';
  return text + pose_text(mechanism, end_of(result, mechanism));
}

std::string newton_json(const NewtonResult& result, const Mechanism& mechanism,
                        const KinematicsHeading& heading) {
  Json report = report_head("newton", heading.file);
  report["at"] = to_json(heading.time);
  report["warnings"] = mechanism.warnings;
  report["units"] = units_json(mechanism);
  report["status"] = to_string(result.status);
  report["message"] = result.message;
  report["steps"] = result.steps();
  report["coordinates"] = coordinates_json(mechanism, end_of(result, mechanism));
  report["residual"] = to_json(result.residual);
  report["scaled_residual"] = to_json(result.scaled_residual);
  report["misfit"] = to_json(misfit(Phi(mechanism), result.q, heading.time));
  report["rank"] = result.rank;
  report["singular"] = result.is_singular;
  report["smallest_singular_value"] = to_json(result.smallest_singular_value);
  report["condition"] = to_json(result.condition);
  report["cycle_length"] = result.cycle_length > 0 ? Json(result.cycle_length) : Json(nullptr);
  report["iterations"] = list_json(result.iterations, iteration_json);
  return to_text(report);
}

std::string newton_csv(const NewtonResult& result, const Mechanism& mechanism,
                       const AngleForm& form) {
  const std::vector<Coordinate> all = coordinates(mechanism);
  std::string text = "iteration,residual,scaled_residual,step,rank,method";
  for (const Coordinate& coordinate : all) {
    text += ',' + column_name(coordinate.name, coordinate.kind, form);
  }
  text += '\n';
  std::size_t k = 0;
  for (const NewtonIteration& iteration : result.iterations) {
    text += std::to_string(k++) + ',' + exact_text(iteration.residual) + ',' +
            exact_text(iteration.scaled_residual) + ',' + exact_text(iteration.step) + ',' +
            std::to_string(iteration.rank) + ',' + to_string(iteration.method);
    for (std::size_t c = 0; c < all.size(); ++c) {
      const double value = iteration.q[static_cast<Eigen::Index>(c)];
      text += ',' + exact_text(in_form(value, all[c].kind, form));
    }
    text += '\n';
  }
  return text;
}

}  // namespace moivre
