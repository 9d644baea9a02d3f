// SPDX-License-Identifier: MIT
// Closures for people: the answer, the account of the paths, every pose in the file's units.
#include <algorithm>
#include <numbers>

#include "free_motion.h"
#include "joint_values.h"
#include "moivre/closure_report/closure_report.h"
#include "moivre/closures/idle_joints.h"
#include "moivre/expression/counted.h"
#include "moivre/expression/joined.h"
#include "moivre/kinematics/followed_motion.h"
#include "moivre/mechanism/closure_id.h"
#include "moivre/report/number_text.h"
#include "moivre/report/text_blocks.h"
#include "pose_text.h"

namespace moivre {
namespace {

/// " = 8 x 8 x 8 of 3 independent sub-chains", the real closures of each.
std::string factors_text(const ClosureResult& result) {
  if (result.sub_chains.empty()) return "";
  std::vector<std::string> factors;
  for (const SubChain& part : result.sub_chains) {
    factors.push_back(std::to_string(part.counts.real));
  }
  return " = " + joined(factors, " x ") + " of " + std::to_string(factors.size()) +
         " independent sub-chains";
}

/// Of the complex closures that are listed.
std::string completeness_line(const ClosureResult& result) {
  if (!result.completeness) return "";
  if (*result.completeness == RootCompleteness::proved) {
    return "every closure is certified, and there can be no more: proved complete\n";
  }
  const auto& roots = result.solutions;
  const auto count = [&](auto claim) {
    return static_cast<std::uint64_t>(std::count_if(roots.begin(), roots.end(), claim));
  };
  const std::uint64_t regular = count([](const Solution& root) { return !root.singular; });
  const std::uint64_t certified =
      count([](const Solution& root) { return root.certified == true; });
  return std::to_string(certified) + " of " + counted(regular, "regular complex closure") +
         " certified: completeness " + to_string(*result.completeness) + '\n';
}

std::string answer(const ClosureResult& result) {
  std::string text = counts_text(result.counts) + factors_text(result);
  if (result.counts.filtered > 0) {
    text += ", " + std::to_string(result.counts.filtered) + " outside a joint's limits";
  }
  text += fitted_text(result.counts);
  if (result.counts.rejected > 0) {
    text += "; " + counted(result.counts.rejected, "root") + " failed the redundant equations";
  }
  return text + '\n' + result.message + '\n' + completeness_line(result);
}

std::string stages_text(const ClosureResult& result) {
  std::string text = counted(result.paths.tracked, "path") + " (" + to_string(result.start.source) +
                     ", " + result.tracker + ", seed " + std::to_string(result.seed) +
                     "): " + std::to_string(result.paths.finite) + " finite, " +
                     std::to_string(result.paths.at_infinity) + " at infinity, " +
                     std::to_string(result.paths.failed) + " failed" +
                     (result.paths.not_needed == 0
                          ? "\n"
                          : ", " + std::to_string(result.paths.not_needed) + " not needed\n");
  for (const Stage& stage : result.stages) {
    text += "  " + stage.group + ": " + counted(stage.paths.tracked, "path") + " in " +
            counted(stage.solves, "solve") + '\n';
  }
  return text;
}

std::string joints_text(const Mechanism& mechanism, const Eigen::VectorXd& q) {
  std::string text;
  for (const JointValue& joint : joint_values(mechanism, q)) {
    text += text.empty() ? "  joints: " : ", ";
    text += joint.name + " = " +
            coordinate_text(mechanism, Coordinate{joint.name, joint.kind, 0}, joint.value);
  }
  return text.empty() ? text : text + '\n';
}

/// `name`: what the commands know the closure by.
std::string closure_text(const Closure& closure, const std::string& name,
                         const Mechanism& mechanism, const std::vector<Coordinate>& names) {
  std::string text =
      "\nclosure " + name + (closure.is_drawn ? ", as drawn" : "") +
      (closure.is_fitted ? ", by least squares" : ", path " + std::to_string(closure.path));
  if (const std::string several = multiplicity_text(closure); !several.empty()) {
    text += ", " + several;
  }
  text += ", residual " + rough_text(closure.residual) + ", " +
          counted(static_cast<std::uint64_t>(closure.newton_iterations), "Newton step") +
          ", smallest singular value " + rough_text(closure.smallest_singular_value);
  if (closure.is_fitted) {
    const std::string& unit = mechanism.units.length;
    text += ", misfit " + rough_text(closure.misfit) + (unit.empty() ? "" : " " + unit);
  }
  if (closure.play) text += ", play " + rough_text(*closure.play);
  if (closure.singular) text += ", singular";
  if (closure.certified == true) text += ", certified";
  return text + '\n' + joints_text(mechanism, closure.q) + pose_text(mechanism, names, closure.q);
}

std::string closures_text(const std::vector<Closure>& closures, const Mechanism& mechanism) {
  const std::vector<Coordinate> names = coordinates(mechanism);
  std::string text;
  for (const Closure& closure : closures) {
    text += closure_text(closure, closure.id, mechanism, names);
  }
  return text;
}

/// How closures of the whole are named.
std::string names_text(const ClosureResult& result) {
  if (result.closures.empty()) return "";
  const auto told = [](const Closure& closure) {
    std::vector<std::string> parts;
    for (std::size_t k = 0; k < closure.of.size(); ++k) {
      parts.push_back(sub_chain_name(k, closure.of[k]));
    }
    const std::string dotted = joined(closure.of, ".");
    return joined(parts, " with ") + " is closure " + closure.id +
           (closure.id == dotted ? "" : ", or " + dotted);
  };
  const auto& all = result.closures;
  const auto drawn =
      std::find_if(all.begin(), all.end(), [](const Closure& one) { return one.is_drawn; });
  return "a closure of the whole is one of each: " + told(all.front()) +
         (drawn == all.end() ? "" : "; as drawn: " + told(*drawn)) + '\n';
}

/// Each with what the drivers place; closures of the whole are one of each.
std::string sub_chains_text(const ClosureResult& result) {
  std::string text = result.sub_chains.empty() ? "" : names_text(result);
  for (std::size_t k = 0; k < result.sub_chains.size(); ++k) {
    const SubChain& part = result.sub_chains[k];
    text += "\nsub-chain " + std::to_string(k + 1) + ", " + joined(part.chain.bodies, ", ") + ": " +
            counts_text(part.counts) + fitted_text(part.counts) + '\n';
    const std::vector<Coordinate> names = coordinates(part.chain.mechanism);
    for (const Closure& closure : part.closures) {
      text += closure_text(closure, sub_chain_name(k, closure.id), part.chain.mechanism, names);
    }
  }
  return text;
}

/// The pose that moves and, where it moves in one direction, along which coordinates; where motions
/// cross, of each that was followed.
std::string moves_text(const ClosureResult& result, const Mechanism& mechanism) {
  if (!result.moves) return "";
  std::string text = "\nmoves from this pose in " + counted(result.moves->dimension, "direction") +
                     ": " + result.moves->shown + '\n' + pose_text(mechanism, result.moves->pose);
  if (result.moves->dimension != 1) return text;
  const Phi phi(hold_idle(mechanism).mechanism);
  const char* which = "  along: ";
  for (const Eigen::VectorXd& along :
       followed_directions(phi, result.moves->pose, result.time, result.seed)) {
    text += which + direction_text(along, mechanism) + '\n';
    which = "  or along: ";
  }
  return text;
}

}  // namespace

std::string closures_text(const ClosureResult& result, const Mechanism& mechanism,
                          const std::string& file) {
  std::string text = (mechanism.title.empty() ? file : mechanism.title + " (" + file + ")") + '\n';
  text += warnings_text(mechanism) + idle_text(result.idle) + answer(result) + stages_text(result);
  text += sub_chains_text(result);
  if (result.sub_chains.empty()) text += closures_text(result.closures, mechanism);
  return text + moves_text(result, mechanism) + left_out_text(result.left_out);
}

}  // namespace moivre
