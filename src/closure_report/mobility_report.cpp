// SPDX-License-Identifier: MIT
// A mobility: counts, redundant rows by name, directions that are free.
#include "free_motion.h"
#include "id_list.h"
#include "moivre/closure_report/kinematics_report.h"
#include "moivre/expression/counted.h"
#include "moivre/expression/joined.h"
#include "moivre/report/number_text.h"
#include "pose_json.h"
#include "pose_text.h"

namespace moivre {
namespace {

Json redundant_json(const RedundantRow& redundant) {
  return {{"row", redundant.name},
          {"combination", list_json(redundant.combination, [](const RowShare& share) {
             return Json{{"row", share.name}, {"coefficient", to_json(share.coefficient)}};
           })}};
}

std::vector<std::string> names_of(const std::vector<Eigen::Index>& indices,
                                  const Mechanism& mechanism) {
  const std::vector<Coordinate> all = coordinates(mechanism);
  std::vector<std::string> names;
  for (const Eigen::Index k : indices) names.push_back(all[static_cast<std::size_t>(k)].name);
  return names;
}

std::string freedoms_text(Eigen::Index freedoms) {
  return counted(static_cast<std::uint64_t>(freedoms), "degree of freedom", "degrees of freedom");
}

/// "generic: " of the first one, unless the rank is higher next to it.
std::string kind_label(const MobilityKind& kind, bool is_first) {
  if (kind.mobility.is_singular) return "singular: ";
  return is_first ? "generic: " : "";
}

/// A line a kind; what follows in the text is of the first.
std::string kinds_text(const std::vector<MobilityKind>& kinds) {
  std::string text;
  for (const MobilityKind& kind : kinds) {
    const std::vector<std::string>& ids = kind.closures;
    text += kind_label(kind, &kind == &kinds.front()) +
            freedoms_text(kind.mobility.degrees_of_freedom) + ", " +
            std::to_string(kind.mobility.driven_freedoms) + " with the drivers held: " +
            (ids.empty() ? "a pose of the set of closures"
                         : (ids.size() == 1 ? "closure " : "closures ") + id_list(ids)) +
            '\n';
  }
  return text;
}

Json kind_json(const MobilityKind& kind) {
  return {{"closures", kind.closures},
          {"rank", kind.mobility.rank},
          {"degrees_of_freedom", kind.mobility.degrees_of_freedom},
          {"driven_freedoms", kind.mobility.driven_freedoms},
          {"redundant", list_json(kind.mobility.redundant,
                                  [](const RedundantRow& row) { return Json(to_text(row)); })},
          {"singular", kind.mobility.is_singular}};
}

/// What the rank and the freedoms hold within, where the file has a fit.
std::string fit_text(const Mobility& mobility, const Mechanism& mechanism) {
  const std::string unit = mechanism.units.length.empty() ? "" : " " + mechanism.units.length;
  return "within fit = " + short_text(*mechanism.fit) + unit + ": the pose misses by " +
         rough_text(mobility.misfit) + unit +
         ", and constraints that differ by no more than fit count as redundant\n";
}

}  // namespace

bool is_taken(const Mobility& mobility, const NewtonResult& pose) {
  const bool is_least = pose.status == NewtonStatus::no_solution;
  return pose.status == NewtonStatus::converged || (is_least && mobility.is_assembled);
}

std::string mobility_text(const Mobility& mobility, const NewtonResult& pose,
                          const Mechanism& mechanism, const KinematicsHeading& heading) {
  const auto count = [](Eigen::Index number, const char* noun) {
    return counted(static_cast<std::uint64_t>(number), noun);
  };
  std::string text =
      (mechanism.title.empty() ? "" : mechanism.title + " ") + "(" + heading.file + ")\n";
  text += warnings_text(mechanism) + kinds_text(heading.kinds);
  if (mechanism.fit) text += fit_text(mobility, mechanism);
  if (!is_taken(mobility, pose)) {
    text += "not assembled: Newton-Raphson ended with " + to_string(pose.status) +
            ". The rest is about its last iterate. --guess sets another start" +
            (mechanism.space == Space::planar ? ", moivre guesses lists good ones" : "") + "\n";
  }
  text += count(mobility.coordinates, "coordinate") + ", " +
          count(mobility.constraints, "constraint") + " of rank " + std::to_string(mobility.rank) +
          (mobility.rank_by_svd == mobility.rank
               ? ""
               : " (" + std::to_string(mobility.rank_by_svd) + " by singular values)") +
          ": " +
          counted(static_cast<std::uint64_t>(mobility.degrees_of_freedom), "degree of freedom",
                  "degrees of freedom") +
          '\n' + "Gruebler's count: " + std::to_string(mobility.gruebler) + "; " +
          count(mobility.drivers, "driver") + ", which leave " +
          std::to_string(mobility.driven_freedoms) + " free\n";
  for (const RedundantRow& row : mobility.redundant) text += "redundant: " + to_text(row) + '\n';
  for (const IdleFreedom& idle : mobility.idle) {
    text += "idle: " + idle.name + ", along " + direction_text(idle.direction, mechanism) + '\n';
  }
  for (const std::string& warning : mobility.warnings) text += "warning: " + warning + '\n';
  text +=
      "independent coordinates: " + joined(names_of(mobility.independent, mechanism), ", ") + '\n';
  // Where rank is lost not every null vector is the direction of a motion.
  const std::string moves = mobility.is_singular ? "free to first order along: " : "moves along: ";
  for (Eigen::Index k = 0; k < mobility.null_space.cols(); ++k) {
    text += moves + direction_text(mobility.null_space.col(k), mechanism) + '\n';
  }
  return text + "pose:\n" + pose_text(mechanism, pose.q);
}

std::string mobility_json(const Mobility& mobility, const NewtonResult& pose,
                          const Mechanism& mechanism, const KinematicsHeading& heading) {
  Json report = report_head("mobility", heading.file);
  report["at"] = to_json(heading.time);
  report["units"] = units_json(mechanism);
  report["assembled"] = is_taken(mobility, pose);
  report["fit"] = mechanism.fit ? to_json(*mechanism.fit) : Json(nullptr);
  report["misfit"] = to_json(mobility.misfit);
  report["coordinates"] = mobility.coordinates;
  report["constraints"] = mobility.constraints;
  report["drivers"] = mobility.drivers;
  report["rank"] = mobility.rank;
  report["rank_by_svd"] = mobility.rank_by_svd;
  report["degrees_of_freedom"] = mobility.degrees_of_freedom;
  report["gruebler"] = mobility.gruebler;
  report["driven_freedoms"] = mobility.driven_freedoms;
  report["redundant"] =
      list_json(mobility.redundant, [](const RedundantRow& row) { return Json(to_text(row)); });
  report["redundant_rows"] = list_json(mobility.redundant, redundant_json);
  report["idle"] = list_json(mobility.idle, [](const IdleFreedom& idle) {
    return Json{{"name", idle.name}, {"direction", to_json(idle.direction)}};
  });
  report["independent"] = names_of(mobility.independent, mechanism);
  report["singular"] = mobility.is_singular;
  report["near_singular"] = mobility.is_near_singular;
  report["rank_nearby"] = mobility.rank_nearby;
  std::vector<std::string> warnings = mechanism.warnings;
  warnings.insert(warnings.end(), mobility.warnings.begin(), mobility.warnings.end());
  report["warnings"] = warnings;
  report["generic_degrees_of_freedom"] = mobility.coordinates - mobility.rank_nearby;
  report["kinds"] = list_json(heading.kinds, kind_json);
  report["pose"] = coordinates_json(mechanism, pose.q);
  report["rows"] = mobility.row_names;
  report["singular_values"] = to_json(mobility.singular_values);
  report["null_space"] = rows_json(mobility.null_space.transpose());
  report["left_null_space"] = rows_json(mobility.left_null_space.transpose());
  report["force_directions"] = rows_json(mobility.force_directions.transpose());
  return to_text(report);
}

}  // namespace moivre
