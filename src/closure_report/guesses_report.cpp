// SPDX-License-Identifier: MIT
// Guesses: [guess] blocks to paste, a table, JSON.
#include <cstdio>
#include <numbers>

#include "moivre/closure_report/kinematics_report.h"
#include "moivre/expression/counted.h"
#include "moivre/report/json.h"
#include "moivre/report/number_text.h"

namespace moivre {

std::string guesses_text(const InitialGuesses& guesses, const Completeness& completeness,
                         const Mechanism& mechanism, const KinematicsHeading& heading) {
  const std::vector<Coordinate> all = coordinates(mechanism);
  const bool in_degrees = mechanism.units.angle == "deg";
  std::string text = "# " + heading.file + ": " +
                     counted(guesses.guesses.size(), "initial guess", "initial guesses") +
                     " for a Newton solve\n";
  if (!completeness.complete) text += "# not complete: " + completeness.message + '\n';
  for (const InitialGuess& guess : guesses.guesses) {
    text += "\n[guess]  # " + guess.id + '\n';
    for (std::size_t k = 0; k < all.size(); ++k) {
      const bool is_angle = all[k].kind != CoordinateKind::length;
      const double value = guess.q[static_cast<Eigen::Index>(k)];
      text += '"' + all[k].name + "\" = " +
              exact_text(is_angle && in_degrees ? value * 180 / std::numbers::pi : value) + '\n';
    }
  }
  return text;
}

std::string guesses_json(const InitialGuesses& guesses, const Completeness& completeness,
                         const KinematicsHeading& heading) {
  Json report = report_head("guesses", heading.file);
  report["at"] = to_json(heading.time);
  report["complete"] = completeness.complete;
  report["message"] = completeness.message;
  report["units"] = {{"angle", "rad"}};
  report["names"] = guesses.names;
  report["guesses"] = list_json(guesses.guesses, [](const InitialGuess& guess) {
    Json q = Json::array();
    for (const double x : guess.q) q.push_back(to_json(x));
    return Json{{"id", guess.id}, {"q", q}};
  });
  return to_text(report);
}

std::string guesses_csv(const InitialGuesses& guesses, const Mechanism& mechanism,
                        const AngleForm& form) {
  const std::vector<Coordinate> all = coordinates(mechanism);
  std::string text = "id";
  for (const Coordinate& coordinate : all) {
    text += ',' + column_name(coordinate.name, coordinate.kind, form);
  }
  text += '\n';
  for (const InitialGuess& guess : guesses.guesses) {
    text += guess.id;
    for (std::size_t k = 0; k < all.size(); ++k) {
      text += ',' + exact_text(in_form(guess.q[static_cast<Eigen::Index>(k)], all[k].kind, form));
    }
    text += '\n';
  }
  return text;
}

}  // namespace moivre
