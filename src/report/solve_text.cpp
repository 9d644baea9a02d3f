// SPDX-License-Identifier: MIT
// A solve for people: the account of the paths, the real roots, what was left out and what failed.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "moivre/expression/counted.h"
#include "moivre/expression/joined.h"
#include "moivre/expression/utf8.h"
#include "moivre/report/number_text.h"
#include "moivre/report/solve_report.h"
#include "moivre/report/text_blocks.h"
#include "moivre/report/text_pieces.h"

namespace moivre {
namespace {

// Failures shown one by one; JSON has them all.
constexpr std::size_t kFailuresShown = 20;
// Points of sets shown where not all are asked for: one may do.
constexpr std::size_t kSetPointsShown = 3;

std::string system_line(const SolveResult& result, const std::string& file) {
  std::string text = file + ": " + counted(result.system.degrees.size(), "equation") + " in " +
                     counted(result.system.variables.size(), "unknown") + ", degrees " +
                     degrees_text(result.system.degrees) + ", total degree " +
                     count_text(result.system.total_degree) + '\n';
  if (result.reduced.isotropic_pairs > 0) {
    text += counted(result.reduced.isotropic_pairs, "pair") +
            " of unknowns tracked as x + iy and x - iy\n";
  }
  if (result.start.paths > 0 && result.reduced.degrees != result.system.degrees) {
    text += "tracked as " + counted(result.reduced.degrees.size(), "equation") + " in " +
            counted(result.reduced.variables.size(), "unknown") +
            (result.reduced.degrees.empty() ? ""
                                            : ", degrees " + degrees_text(result.reduced.degrees)) +
            '\n';
  }
  return text;
}

std::string paths_line(const SolveResult& result) {
  const PathCounts& paths = result.paths;
  if (result.start.paths == 0) return "no path to track\n";
  std::string text = counted(paths.tracked, "path") + " (" + to_string(result.start.source) + ", " +
                     result.tracker + ", seed " + std::to_string(result.seed) +
                     "): " + std::to_string(paths.finite) + " finite, " +
                     std::to_string(paths.at_infinity) + " at infinity, " +
                     std::to_string(paths.failed) + " failed";
  if (paths.not_needed > 0) text += ", " + std::to_string(paths.not_needed) + " not needed";
  if (paths.by_count > 0) {
    text += ", " + std::to_string(paths.by_count) +
            " of the finite by a count of the roots, not seen there";
  }
  if (paths.on_positive_dimensional > 0) {
    text += ", " + std::to_string(paths.on_positive_dimensional) +
            " of the finite on sets of positive dimension";
  }
  if (paths.retracked > 0) text += "; " + std::to_string(paths.retracked) + " tracked again";
  if (paths.handed_over > 0) {
    text += ", ";
    text += std::to_string(paths.handed_over) + " of them by the other tracker";
  }
  if (paths.double_double > 0) {
    text += paths.retracked > 0 ? ", " : "; ";
    text += std::to_string(paths.double_double) + " in double-double";
  }
  if (paths.multiprecision > 0) {
    text += paths.retracked > 0 ? ", " : "; ";
    text += std::to_string(paths.multiprecision) + " in more digits";
  }
  return text + '\n';
}

std::string roots_line(const SolveResult& result) {
  const auto& roots = result.solutions;
  const auto count = [&](auto claim) {
    return static_cast<std::uint64_t>(std::count_if(roots.begin(), roots.end(), claim));
  };
  const std::uint64_t real = count([](const Solution& root) { return root.real; });
  std::string text = counted(roots.size(), "isolated root") + ": " + std::to_string(real) +
                     " real, " + std::to_string(roots.size() - real) + " not real";
  const std::uint64_t singular = count([](const Solution& root) { return root.singular; });
  if (singular > 0) text += "; " + std::to_string(singular) + " singular";
  const std::uint64_t clusters = count([](const Solution& root) { return root.cluster; });
  if (clusters > 0) text += ", " + std::to_string(clusters) + " of them clusters";
  if (result.excess > 0) {
    text += "; " +
            counted(result.excess, "root of the squared-up system fails",
                    "roots of the squared-up system fail") +
            " an equation";
  }
  if (result.on_denominators > 0) {
    text += "; " + std::to_string(result.on_denominators) + " more where a denominator is zero";
  }
  if (result.filtered > 0)
    text += "; " + std::to_string(result.filtered) + " more were not asked for";
  return text + '\n';
}

std::string completeness_line(const SolveResult& result) {
  if (!result.completeness) return "";
  const auto& roots = result.solutions;
  if (result.bound) {
    const std::uint64_t left_out = result.filtered + result.on_denominators;
    const std::string others =
        left_out > 0 ? " and " + std::to_string(left_out) + " left out" : std::string();
    return counted(roots.size(), "root") + others + ", " + std::to_string(result.bound->value) +
           " = " + name_in_results(result.bound->kind) + ": proved complete\n";
  }
  const auto count = [&](auto claim) {
    return static_cast<std::uint64_t>(std::count_if(roots.begin(), roots.end(), claim));
  };
  // A multiple root is certified where the equations are powers, by their bases.
  const auto is_regular = [](const Solution& root) { return !root.singular; };
  const std::uint64_t certified =
      count([](const Solution& root) { return root.certified == true; });
  const std::uint64_t certifiable =
      count([&](const Solution& root) { return is_regular(root) || root.certified == true; });
  if (certifiable == 0) {
    return "no regular root to certify: completeness " + to_string(*result.completeness) + '\n';
  }
  const bool all_regular = certifiable == count(is_regular);
  return std::to_string(certified) + " of " +
         counted(certifiable, all_regular ? "regular root" : "root") + " certified: completeness " +
         to_string(*result.completeness) + '\n';
}

/// All the digits that were asked for, or those that the accuracy justifies.
std::string coordinate_text(const Solution& root, std::size_t i, double error) {
  if (root.x_digits.empty()) {
    return root.real ? known_digits(root.x[i].real(), error) : known_digits(root.x[i], error);
  }
  const auto& [re, im] = root.x_digits[i];
  if (im == "0") return re;
  return re + (im.front() == '-' ? " - " + im.substr(1) : " + " + im) + " i";
}

std::string coordinates_text(const Solution& root, const std::vector<std::string>& names) {
  std::size_t width = 0;
  for (const std::string& name : names) width = std::max(width, utf8_characters(name));
  const double error = root.accuracy * std::max(1.0, max_norm(root.x));
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string value = coordinate_text(root, i, error);
    text += "  " + names[i] + std::string(width - utf8_characters(names[i]), ' ') + " = " +
            (value.front() == '-' ? "" : " ") + value + '\n';
  }
  return text;
}

std::string root_text(const Solution& root, const std::vector<std::string>& names) {
  std::string text =
      std::string(root.real ? "real root" : "root") + ", path " + std::to_string(root.path);
  if (root.cluster) {
    text += ", a cluster of " + counted(root.multiplicity, "root") + " within " +
            rough_text(root.radius);
  } else if (root.multiplicity > 1) {
    text += ", multiplicity " + std::to_string(root.multiplicity);
  }
  if (root.singular) text += ", singular";
  if (root.certified == true) text += ", certified";
  text += ", accuracy " + rough_text(root.accuracy) + ", condition " + rough_text(root.condition);
  if (!root.on_boundary.empty()) text += ", on the boundary of " + joined(root.on_boundary, ", ");
  text += '\n';
  return text + coordinates_text(root, names);
}

void write_roots(TextPieces& text, const SolveResult& result, ListedRoots listed) {
  std::uint64_t hidden = 0;
  for (const Solution& root : result.solutions) {
    if (root.real || listed == ListedRoots::all) {
      text += '\n' + root_text(root, result.system.variables);
    } else {
      ++hidden;
    }
  }
  if (hidden > 0) {
    text += '\n' + counted(hidden, "root is", "roots are") + " not real (--all lists " +
            (hidden == 1 ? "it" : "them") + ")\n";
  }
}

/// "every equation is zero on the plane s = x2 = 0, of dimension 1"
void write_planes(TextPieces& text, const SolveResult& result) {
  for (const CoordinatePlane& plane : result.planes) {
    text += "\nevery equation is zero on the plane " +
            joined(zero_names(plane, result.system.variables), " = ") + " = 0, of dimension " +
            std::to_string(plane.dimension) + '\n';
  }
}

/// The real ones first.
void write_set_points(TextPieces& text, const SolveResult& result, ListedRoots listed) {
  std::vector<Solution> points = result.on_sets;
  std::stable_partition(points.begin(), points.end(), [](const Solution& x) { return x.real; });
  const std::size_t shown =
      listed == ListedRoots::all ? points.size() : std::min(points.size(), kSetPointsShown);
  for (std::size_t k = 0; k < shown; ++k) {
    text += std::string("\n") + (points[k].real ? "real point" : "point") +
            " of a set of positive dimension, " + counted(points[k].multiplicity, "path") + '\n' +
            coordinates_text(points[k], result.system.variables);
  }
  if (shown < points.size()) {
    text +=
        '\n' + counted(points.size() - shown, "more point") + " of such sets (--all lists them)\n";
  }
}

std::string failures_text(const std::vector<FailedPath>& failures) {
  if (failures.empty()) return "";
  std::string text = "\nFailed\n";
  for (std::size_t k = 0; k < std::min(failures.size(), kFailuresShown); ++k) {
    text += "  path " + std::to_string(failures[k].path) + ": " + to_string(failures[k].failure) +
            ", at t = " + complex_text(failures[k].t) + '\n';
  }
  if (failures.size() > kFailuresShown) {
    text +=
        "  and " + std::to_string(failures.size() - kFailuresShown) + " more (--json has all)\n";
  }
  return text;
}

std::string cross_check_text(const SolveResult& result) {
  if (!result.cross_check) return "";
  const CrossCheck& check = *result.cross_check;
  std::string text = "cross-check by " + check.witness + ": " + counted(check.common, "root") +
                     " in common, " + std::to_string(check.missed) + " missed here, " +
                     std::to_string(check.unwitnessed) + " missed there\n";
  for (std::size_t k = 0; k < std::min(check.disagreements.size(), kFailuresShown); ++k) {
    const Disagreement& difference = check.disagreements[k];
    text += "  path " + std::to_string(difference.path) + ": different ends; ";
    text += difference.jumped ? *difference.jumped + " had left the path\n"
                              : "following it again did not settle it\n";
  }
  return text;
}

std::string time_line(const SolveTime& time) {
  char text[80];
  std::snprintf(text, sizeof text, "\n%.3g s on ", time.total);
  return text + counted(static_cast<std::uint64_t>(time.threads), "thread") + '\n';
}

}  // namespace

void write_solve_text(const TextSink& sink, const SolveResult& result, const std::string& file,
                      ListedRoots listed) {
  TextPieces text(sink);
  text += system_line(result, file) + paths_line(result) + roots_line(result);
  text += cross_check_text(result);
  text += result.message + '\n' + completeness_line(result);
  write_roots(text, result, listed);
  write_planes(text, result);
  write_set_points(text, result, listed);
  text += failures_text(result.failures);
  text += left_out_text(result.left_out);
  text += time_line(result.time);
  text.flush();
}

std::string solve_text(const SolveResult& result, const std::string& file, ListedRoots listed) {
  return whole_text([&](const TextSink& sink) { write_solve_text(sink, result, file, listed); });
}

}  // namespace moivre
