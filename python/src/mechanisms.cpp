// SPDX-License-Identifier: MIT
// Mechanisms for Python: closures, motion, sweeps and sensitivities as arrays, and every report of
// the library.
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <sstream>

#include "arrays.h"
#include "bindings.h"
#include "choice.h"
#include "moivre/closure_report/closure_report.h"
#include "moivre/closure_report/kinematics_report.h"
#include "moivre/closure_report/motion_report.h"
#include "moivre/closure_report/page.h"
#include "moivre/closure_report/sensitivity_report.h"
#include "moivre/closure_report/sweep_report.h"
#include "moivre/closures/guesses.h"
#include "moivre/closures/mobility_kinds.h"
#include "moivre/design/sensitivity.h"
#include "moivre/kinematics/newton.h"
#include "moivre/mechanism/dimensions.h"
#include "moivre/mechanism/mechanism.h"
#include "moivre/mechanism/named_values.h"
#include "moivre/mechanism/phi.h"
#include "moivre/mechanism/pose.h"
#include "moivre/mechanism/read.h"
#include "moivre/motion/circuits.h"
#include "moivre/motion/motion.h"
#include "moivre/numeric/invalid_input.h"
#include "moivre/sweep/sweep.h"
#include "moivre/urdf/mechanism_text.h"
#include "moivre/urdf/read.h"
#include "poses.h"

namespace moivre::python {
namespace {

namespace py = pybind11;

/// A mechanism and where it was read.
struct NamedMechanism {
  std::string file;
  Mechanism mechanism;
};
using Shared = std::shared_ptr<const NamedMechanism>;

struct FoundClosures {
  Shared of;
  ClosureResult result;
};

struct FoundMotion {
  Shared of;
  MotionResult result;
};

struct FoundSweep {
  Shared of;
  SweepResult result;
};

std::shared_ptr<NamedMechanism> read(const Source& source) {
  return std::make_shared<NamedMechanism>(NamedMechanism{source.name, read_mechanism(source)});
}

/// A robot as a mechanism: pose 4 x 4 of the tip, or None; loops: the path of a side file.
std::shared_ptr<NamedMechanism> of_robot(const Source& source,
                                         const std::optional<std::string>& tip,
                                         const std::vector<std::pair<std::string, double>>& held,
                                         const std::optional<Eigen::Matrix4d>& pose,
                                         const std::optional<std::string>& loops) {
  RobotChanges changes;
  for (const auto& [joint, value] : held) changes.held.push_back({joint, value});
  changes.tip = tip;
  if (pose) changes.pose = pose_of(*pose, "pose: ");
  if (loops) changes.loops = read_source(*loops);
  return read(
      {source.name + ", as a mechanism", mechanism_text(read_urdf(source), source.name, changes)});
}

/// choice[name]: (name, value) of coordinates; angles in the file's unit.
std::vector<NamedValue> named_values(const py::dict& choice, const char* name) {
  std::vector<NamedValue> given;
  if (!choice.contains(name)) return given;
  for (const py::handle& each : choice[name]) {
    const auto [coordinate, value] = each.cast<std::pair<std::string, double>>();
    std::ostringstream said;
    said << coordinate << '=' << value;
    given.push_back({coordinate, value, said.str()});
  }
  return given;
}

/// Where values are given by choice[name]; their names are refused as those of that argument.
Eigen::VectorXd with_values_of(const py::dict& choice, const char* name, const Mechanism& mechanism,
                               const Eigen::VectorXd& base, AngleUnit unit) {
  const std::vector<NamedValue> given = named_values(choice, name);
  std::vector<std::string> broken = broken_rules(mechanism, given, unit);
  for (std::string& rule : broken) rule.insert(0, std::string(name) + ": ");
  require_unbroken(broken);
  return with_values(mechanism, given, base, unit);
}

/// The file's initial guess at that time, with the values of choice["guess"].
Eigen::VectorXd guess_of(const py::dict& choice, const Mechanism& mechanism, double time) {
  return with_values_of(choice, "guess", mechanism, initial_guess(mechanism, time),
                        AngleUnit::of_the_file);
}

bool is_asked(const py::dict& choice, const char* name) {
  return choice.contains(name) && option_value<bool>(name, choice[name]);
}

/// "rad" or "deg".
AngleForm angle_form(const std::string& unit, bool goes_on = false) {
  if (unit == "rad" || unit == "deg") return {unit == "deg", goes_on};
  throw std::invalid_argument("angles: \"rad\" or \"deg\" is wanted, \"" + unit + "\" is given");
}

Views views_of(const FoundClosures& found, bool three_views) {
  if (three_views && found.of->mechanism.space != Space::spatial) {
    throw std::invalid_argument("three_views: only a spatial mechanism is seen from three sides");
  }
  return three_views ? Views::three : Views::standing;
}

/// fit, all_meshings and tolerance of the choice.
Shared changed(const Shared& of, const py::dict& choice) {
  NamedMechanism copy = *of;
  if (choice.contains("fit")) {
    const auto fit = option_value<double>("fit", choice["fit"]);
    if (!(fit > 0) || !is_workable(fit))
      throw std::invalid_argument("fit must be a length above 0");
    copy.mechanism.fit = fit;
  }
  if (choice.contains("tolerance")) {
    const auto tolerance = option_value<double>("tolerance", choice["tolerance"]);
    if (!(tolerance >= 0) || !is_workable(tolerance)) {
      throw std::invalid_argument("tolerance must be a length from 0 up");
    }
    copy.mechanism.tolerance = tolerance;
  }
  if (choice.contains("meshings") && option_value<bool>("meshings", choice["meshings"])) {
    for (Joint& joint : copy.mechanism.joints) joint.gear.has_all_meshings = true;
  }
  return std::make_shared<const NamedMechanism>(std::move(copy));
}

double finite(const py::dict& choice, const char* name, double otherwise) {
  if (!choice.contains(name)) return otherwise;
  const auto value = option_value<double>(name, choice[name]);
  if (!std::isfinite(value)) throw std::invalid_argument(std::string(name) + " is not finite");
  return value;
}

FoundClosures closures(const Shared& named, const py::dict& choice, const py::object& progress) {
  const Shared of = changed(named, choice);
  const Trackers trackers = make_trackers(choice);
  ClosureOptions options;
  options.time = finite(choice, "at", 0);
  options.with_mobility = true;
  options.solve = solve_options(choice, trackers);
  return overseen(terms_of(choice, progress), [&](Oversight& oversight) {
    options.solve = overseen_by(oversight, options.solve);
    return FoundClosures{of,
                         find_closures(of->mechanism, *trackers.chosen, options, oversight.stop())};
  });
}

std::vector<std::string> names_of_coordinates(const Mechanism& mechanism) {
  std::vector<std::string> names;
  for (const Coordinate& coordinate : coordinates(mechanism)) names.push_back(coordinate.name);
  return names;
}

/// "crank.B" of every point of the moving bodies, in the order of point_states().
std::vector<std::string> names_of_points(const Mechanism& mechanism) {
  std::vector<std::string> names;
  for (std::size_t body = 1; body < mechanism.bodies.size(); ++body) {
    for (const BodyPoint& point : mechanism.bodies[body].points) {
      names.push_back(mechanism.bodies[body].name + "." + point.name);
    }
  }
  return names;
}

/// (points, 3) at q.
py::array_t<double> points_at(const NamedMechanism& named, const Eigen::VectorXd& q) {
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(q.size());
  const std::vector<PointState> states = is_typed(named.mechanism)
                                             ? std::vector<PointState>{}
                                             : point_states(named.mechanism, q, still, still);
  return rows<double>(
      states, 3, [](const PointState& state) -> const Eigen::Vector3d& { return state.position; });
}

/// q: (k, n); (k, 2) of a planar mechanism, (k, 3) of a spatial one.
Eigen::MatrixXd positions_of(const NamedMechanism& named, const std::string& point,
                             const Eigen::MatrixXd& q) {
  const PointOf at = point_named(named.mechanism, point);
  Eigen::MatrixXd positions(q.rows(), named.mechanism.space == Space::spatial ? 3 : 2);
  for (Eigen::Index k = 0; k < q.rows(); ++k) {
    positions.row(k) =
        point_position(named.mechanism, at, q.row(k)).head(positions.cols()).transpose();
  }
  return positions;
}

py::dict closure_arrays(const FoundClosures& found) {
  const std::vector<Closure>& list = found.result.closures;
  const std::size_t n = coordinates(found.of->mechanism).size();
  py::dict arrays;
  arrays["q"] =
      rows<double>(list, n, [](const Closure& c) -> const Eigen::VectorXd& { return c.q; });
  arrays["multiplicity"] =
      column<std::int64_t>(list, [](const Closure& c) { return c.multiplicity; });
  arrays["singular"] = column<bool>(list, [](const Closure& c) { return c.singular; });
  arrays["residual"] = column<double>(list, [](const Closure& c) { return c.residual; });
  arrays["misfit"] = column<double>(list, [](const Closure& c) { return c.misfit; });
  arrays["fitted"] = column<bool>(list, [](const Closure& c) { return c.is_fitted; });
  arrays["drawn"] = column<bool>(list, [](const Closure& c) { return c.is_drawn; });
  py::list ids, certified, play;
  for (const Closure& c : list) {
    ids.append(c.id);
    certified.append(optional_bool(c.certified));
    play.append(c.play ? py::object(py::float_(*c.play)) : py::object(py::none()));
  }
  arrays["ids"] = ids;
  arrays["play"] = play;
  arrays["certified"] = certified;
  return arrays;
}

py::dict closure_counts(const FoundClosures& found) {
  const ClosureCounts& counts = found.result.counts;
  py::dict dict;
  dict["complex"] = counts.complex;
  dict["real"] = counts.real;
  dict["filtered"] = counts.filtered;
  dict["rejected"] = counts.rejected;
  dict["fitted"] = counts.fitted;
  return dict;
}

py::dict sensitivity(const FoundClosures& found) {
  const Sensitivities told = closure_sensitivities(found.of->mechanism, found.result);
  py::dict dict;
  std::vector<std::string> dimensions, quantities;
  for (const Dimension& dimension : told.dimensions) dimensions.push_back(dimension.name);
  for (const SensitiveQuantity& quantity : told.quantities) {
    const bool is_point = quantity.group == SensitiveGroup::point;
    quantities.push_back(quantity.name + (is_point ? std::string{'.', "xyz"[quantity.axis]} : ""));
  }
  dict["dimensions"] = dimensions;
  dict["quantities"] = quantities;
  dict["values"] = column<double>(told.values, [](double value) { return value; });
  dict["tolerances"] = column<double>(told.tolerances, [](double value) { return value; });
  py::list list;
  for (const ClosureSensitivity& closure : told.closures) {
    py::dict each;
    each["id"] = closure.id;
    each["missing"] = closure.missing;
    each["rates"] = closure.rates;
    each["worst_case"] = closure.worst_case;
    each["root_sum_square"] = closure.root_sum_square;
    list.append(each);
  }
  dict["closures"] = list;
  dict["text"] = sensitivity_text(told, found.of->mechanism);
  dict["csv"] = sensitivity_csv(told, found.of->mechanism);
  dict["csv_in_degrees"] = sensitivity_csv(told, found.of->mechanism, angle_form("deg"));
  dict["json"] = closures_json(found.result, found.of->mechanism, found.of->file, &told);
  return dict;
}

py::dict guesses(const FoundClosures& found) {
  const InitialGuesses told = initial_guesses(found.result, found.of->mechanism);
  py::dict dict;
  std::vector<std::string> ids;
  for (const InitialGuess& guess : told.guesses) ids.push_back(guess.id);
  dict["names"] = told.names;
  dict["ids"] = ids;
  dict["q"] =
      rows<double>(told.guesses, told.names.size(),
                   [](const InitialGuess& guess) -> const Eigen::VectorXd& { return guess.q; });
  const KinematicsHeading heading{found.of->file, found.result.time, {}};
  const Completeness completeness{found.result.complete, found.result.message};
  dict["json"] = guesses_json(told, completeness, heading);
  dict["text"] = guesses_text(told, completeness, found.of->mechanism, heading);
  dict["csv"] = guesses_csv(told, found.of->mechanism, {});
  dict["csv_in_degrees"] = guesses_csv(told, found.of->mechanism, angle_form("deg"));
  return dict;
}

FoundMotion motion(const Shared& named, const py::dict& choice, const py::object& progress) {
  const Shared of = changed(named, choice);
  const Trackers trackers = make_trackers(choice);
  MotionOptions options;
  options.from = finite(choice, "from", 0);
  options.to = finite(choice, "to", options.from + natural_duration(of->mechanism, options.from));
  if (choice.contains("steps")) options.steps = option_value<int>("steps", choice["steps"]);
  if (choice.contains("checkpoints"))
    options.checkpoints = option_value<int>("checkpoints", choice["checkpoints"]);
  require_workable(of->mechanism, options);
  options.solve = solve_options(choice, trackers);
  if (choice.contains("closure"))
    options.asked = choice["closure"].cast<std::vector<std::string>>();
  const bool is_guessed = choice.contains("guess") || is_asked(choice, "from_guess");
  if (is_guessed && !options.asked.empty()) {
    throw std::invalid_argument("closure and guess: a guess is followed without closures");
  }
  const Eigen::VectorXd guess =
      is_guessed ? guess_of(choice, of->mechanism, options.from) : Eigen::VectorXd();
  return overseen(terms_of(choice, progress), [&](Oversight& oversight) {
    options.progress = [&oversight](double share) {
      constexpr std::uint64_t kWhole = 1000;
      oversight.tell(static_cast<std::uint64_t>(share * kWhole), kWhole);
    };
    const std::atomic<bool>& stop = oversight.stop();
    if (is_guessed) return FoundMotion{of, follow_guesses(of->mechanism, {guess}, options, stop)};
    MotionResult result = find_motion(of->mechanism, *trackers.chosen, options, stop);
    if (options.asked.empty() || stop) return FoundMotion{of, std::move(result)};
    const Circuits circuits = find_circuits(of->mechanism, result);
    return FoundMotion{of, reachable_from(std::move(result), circuits, options.asked)};
  });
}

py::dict branch_arrays(const FoundMotion& found, std::size_t index) {
  const MotionBranch& branch = found.result.branches.at(index);
  const std::size_t n = coordinates(found.of->mechanism).size();
  // Where there is none a row is NaN: at a pose whose velocity is not unique.
  const Eigen::VectorXd none = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(n), NAN);
  const auto or_none = [&](const Eigen::VectorXd& row) -> const Eigen::VectorXd& {
    return row.size() == 0 ? none : row;
  };
  py::dict arrays;
  arrays["id"] = branch.id;
  arrays["complete"] = branch.complete;
  arrays["message"] = branch.message;
  arrays["begins"] = branch.begins;
  arrays["ends"] = branch.ends;
  arrays["t"] = column<double>(branch.samples, [](const BranchSample& s) { return s.time; });
  arrays["q"] = rows<double>(branch.samples, n,
                             [](const BranchSample& s) -> const Eigen::VectorXd& { return s.q; });
  arrays["velocity"] = rows<double>(
      branch.samples, n,
      [&](const BranchSample& s) -> const Eigen::VectorXd& { return or_none(s.velocity); });
  arrays["acceleration"] = rows<double>(
      branch.samples, n,
      [&](const BranchSample& s) -> const Eigen::VectorXd& { return or_none(s.acceleration); });
  arrays["begin_event"] = branch.begin_event;
  arrays["end_event"] = branch.end_event;
  return arrays;
}

py::list events_of(const FoundMotion& found) {
  py::list list;
  for (const MotionEvent& event : found.result.events) {
    py::dict each;
    each["kind"] = to_string(event.at.kind);
    each["t"] = event.at.time;
    each["q"] = event.at.q;
    each["drivers"] = event.drivers;
    each["ending"] = event.ending;
    each["beginning"] = event.beginning;
    list.append(each);
  }
  return list;
}

/// varied: (name, from, to, count) each.
FoundSweep swept(const Shared& named,
                 const std::vector<std::tuple<std::string, double, double, std::size_t>>& ranges,
                 const py::dict& choice, const py::object& progress) {
  const Shared of = changed(named, choice);
  const Trackers trackers = make_trackers(choice);
  SweepOptions options;
  options.closures.time = finite(choice, "at", 0);
  options.closures.solve = solve_options(choice, trackers);
  options.keep_closures = true;
  options.sharpen = !choice.contains("borders") || is_asked(choice, "borders");
  std::vector<Varied> varied;
  for (const auto& [name, from, to, count] : ranges) varied.push_back({name, from, to, count});
  return overseen(terms_of(choice, progress), [&](Oversight& oversight) {
    options.progress = [&oversight](std::size_t done, std::size_t total) {
      oversight.tell(done, total);
    };
    FamilyBook book({}, options.closures.solve.seed);
    return FoundSweep{
        of, sweep(of->mechanism, varied, *trackers.chosen, book, options, oversight.stop())};
  });
}

py::dict sweep_arrays(const FoundSweep& found) {
  const SweepResult& result = found.result;
  const std::size_t k = result.varied.size();
  py::dict arrays;
  arrays["at"] = rows<double>(
      result.samples, k, [](const SweepSample& s) -> const std::vector<double>& { return s.at; });
  arrays["real"] =
      column<std::int64_t>(result.samples, [](const SweepSample& s) { return s.found.real; });
  arrays["usable"] =
      column<std::int64_t>(result.samples, [](const SweepSample& s) { return s.found.usable(); });
  arrays["complex"] =
      column<std::int64_t>(result.samples, [](const SweepSample& s) { return s.complex; });
  arrays["moves"] =
      column<bool>(result.samples, [](const SweepSample& s) { return s.found.moves; });
  arrays["complete"] =
      column<bool>(result.samples, [](const SweepSample& s) { return s.complete; });
  arrays["borders"] = rows<double>(
      result.borders, k, [](const SweepBorder& b) -> const std::vector<double>& { return b.at; });
  return arrays;
}

py::dict found_mobility(const Shared& named, const py::dict& choice) {
  const Shared of = changed(named, choice);
  const Trackers trackers = make_trackers(choice);
  const double at = finite(choice, "at", 0);
  std::optional<Eigen::VectorXd> guess;
  if (choice.contains("guess")) guess = guess_of(choice, of->mechanism, at);
  const auto [found, report, text] =
      overseen(terms_of(choice, py::none()), [&](Oversight& oversight) {
        FoundMobility mobility =
            find_mobility(of->mechanism, *trackers.chosen, at, guess, oversight.stop());
        const KinematicsHeading heading{of->file, at, mobility.kinds};
        std::string json = mobility_json(mobility.mobility, mobility.pose, of->mechanism, heading);
        std::string words = mobility_text(mobility.mobility, mobility.pose, of->mechanism, heading);
        return std::tuple(std::move(mobility), std::move(json), std::move(words));
      });
  py::list redundant;
  for (const RedundantRow& row : found.mobility.redundant) redundant.append(to_text(row));
  py::dict dict;
  dict["degrees_of_freedom"] = found.mobility.degrees_of_freedom;
  dict["gruebler"] = found.mobility.gruebler;
  dict["driven_freedoms"] = found.mobility.driven_freedoms;
  dict["rank"] = found.mobility.rank;
  dict["redundant"] = redundant;
  dict["is_singular"] = found.mobility.is_singular;
  dict["is_assembled"] = is_taken(found.mobility, found.pose);
  dict["q"] = found.pose.q;
  dict["null_space"] = found.mobility.null_space;
  dict["json"] = report;
  dict["text"] = text;
  return dict;
}

/// One run of Newton-Raphson, iteration by iteration.
py::dict found_newton(const Shared& of, const py::dict& choice) {
  const Mechanism& mechanism = of->mechanism;
  const double at = finite(choice, "at", 0);
  const Phi phi(mechanism);
  NewtonOptions options;
  options.with_condition = true;
  options.residual_tolerance = finite(choice, "tolerance", options.residual_tolerance);
  if (choice.contains("max_iterations")) {
    options.maximum_iterations = option_value<int>("max_iterations", choice["max_iterations"]);
  }
  if (choice.contains("weight")) {
    options.linear.weights = with_values_of(
        choice, "weight", mechanism, Eigen::VectorXd::Ones(phi.dimension()), AngleUnit::radians);
  }
  const NewtonResult found = newton(phi, guess_of(choice, mechanism, at), at, options);
  const KinematicsHeading heading{of->file, at, {}};
  const auto n = static_cast<std::size_t>(phi.dimension());
  py::dict dict;
  dict["converged"] = found.status == NewtonStatus::converged;
  dict["status"] = to_string(found.status);
  dict["message"] = found.message;
  // A run may go round and round; the pose is that of closures.
  dict["q"] = found.q.allFinite() ? phi.canonical(found.q) : found.q;
  dict["iterates"] = rows<double>(
      found.iterations, n, [](const NewtonIteration& k) -> const Eigen::VectorXd& { return k.q; });
  dict["residuals"] =
      column<double>(found.iterations, [](const NewtonIteration& k) { return k.residual; });
  dict["rank"] = found.rank;
  dict["is_singular"] = found.is_singular;
  dict["condition"] = found.condition;
  dict["json"] = newton_json(found, mechanism, heading);
  dict["text"] = newton_text(found, mechanism, heading);
  return dict;
}

template <class Found>
void bind_result(py::class_<Found>& type) {
  type.def_property_readonly("complete", [](const Found& found) { return found.result.complete; });
}

void bind_closures(py::module_& module) {
  py::class_<FoundClosures> type(module, "FoundClosures");
  bind_result(type);
  type.def_property_readonly("message",
                             [](const FoundClosures& found) { return found.result.message; })
      .def_property_readonly("time", [](const FoundClosures& found) { return found.result.time; })
      .def_property_readonly(
          "completeness",
          [](const FoundClosures& found) { return completeness_of(found.result.completeness); })
      .def_property_readonly(
          "moves", [](const FoundClosures& found) { return found.result.moves.has_value(); })
      .def_property_readonly("counts", &closure_counts)
      .def_property_readonly(
          "paths", [](const FoundClosures& found) { return counts_of(found.result.paths); })
      .def("arrays", &closure_arrays)
      .def("sensitivity", &sensitivity)
      .def("guesses", &guesses)
      .def("json",
           [](const FoundClosures& found) {
             return closures_json(found.result, found.of->mechanism, found.of->file);
           })
      .def("text",
           [](const FoundClosures& found) {
             return closures_text(found.result, found.of->mechanism, found.of->file);
           })
      .def("csv",
           [](const FoundClosures& found, const std::string& angles) {
             return closures_csv(found.result, found.of->mechanism, angle_form(angles));
           })
      .def("svg",
           [](const FoundClosures& found, bool three_views) {
             return closures_svg(found.result, found.of->mechanism, found.of->file,
                                 views_of(found, three_views));
           })
      .def("html", [](const FoundClosures& found) {
        return closures_html(found.result, found.of->mechanism, found.of->file);
      });
}

void bind_motions(py::module_& module) {
  py::class_<FoundMotion> type(module, "FoundMotion");
  bind_result(type);
  type.def_property_readonly("message",
                             [](const FoundMotion& found) { return found.result.message; })
      .def_property_readonly("branches",
                             [](const FoundMotion& found) { return found.result.branches.size(); })
      .def_property_readonly("failures",
                             [](const FoundMotion& found) { return found.result.failures; })
      .def("branch", &branch_arrays)
      .def("events", &events_of)
      .def("json",
           [](const FoundMotion& found, bool continuous) {
             return motion_json(found.result, found.of->mechanism, found.of->file,
                                {false, continuous});
           })
      .def("text",
           [](const FoundMotion& found) {
             return motion_text(found.result, found.of->mechanism, found.of->file);
           })
      .def("csv",
           [](const FoundMotion& found, const std::string& angles, bool continuous) {
             return motion_csv(found.result, found.of->mechanism, angle_form(angles, continuous));
           })
      .def("svg",
           [](const FoundMotion& found) {
             return motion_svg(found.result, found.of->mechanism, found.of->file);
           })
      .def("html", [](const FoundMotion& found) {
        return motion_html(found.result, found.of->mechanism, found.of->file);
      });
}

void bind_sweeps(py::module_& module) {
  py::class_<FoundSweep> type(module, "FoundSweep");
  bind_result(type);
  type.def("arrays", &sweep_arrays)
      .def("json",
           [](const FoundSweep& found) {
             return sweep_json(found.result, found.of->file, found.of->mechanism.warnings);
           })
      .def("text",
           [](const FoundSweep& found) {
             return sweep_text(found.result, found.of->file, found.of->mechanism.warnings);
           })
      .def("csv", [](const FoundSweep& found) { return sweep_csv(found.result); })
      .def("svg", [](const FoundSweep& found) { return sweep_svg(found.result, found.of->file); })
      .def("html", [](const FoundSweep& found) {
        return sweep_html(found.result, found.of->mechanism, found.of->file);
      });
}

}  // namespace

void bind_mechanisms(py::module_& module) {
  py::class_<NamedMechanism, std::shared_ptr<NamedMechanism>>(module, "Mechanism")
      .def_property_readonly("title",
                             [](const NamedMechanism& named) { return named.mechanism.title; })
      .def_property_readonly("warnings",
                             [](const NamedMechanism& named) { return named.mechanism.warnings; })
      .def_property_readonly(
          "is_spatial",
          [](const NamedMechanism& named) { return named.mechanism.space == Space::spatial; })
      .def_property_readonly("is_typed",
                             [](const NamedMechanism& named) { return is_typed(named.mechanism); })
      .def_property_readonly(
          "coordinates",
          [](const NamedMechanism& named) { return names_of_coordinates(named.mechanism); })
      .def_property_readonly(
          "points", [](const NamedMechanism& named) { return names_of_points(named.mechanism); })
      .def_property_readonly(
          "dimensions",
          [](const NamedMechanism& named) { return dimension_names(named.mechanism); })
      .def("points_at", &points_at)
      .def("point_position", &positions_of)
      .def("closures", [](const std::shared_ptr<NamedMechanism>& named, const py::dict& choice,
                          const py::object& progress) { return closures(named, choice, progress); })
      .def("motion", [](const std::shared_ptr<NamedMechanism>& named, const py::dict& choice,
                        const py::object& progress) { return motion(named, choice, progress); })
      .def("sweep",
           [](const std::shared_ptr<NamedMechanism>& named,
              const std::vector<std::tuple<std::string, double, double, std::size_t>>& ranges,
              const py::dict& choice,
              const py::object& progress) { return swept(named, ranges, choice, progress); })
      .def("mobility", [](const std::shared_ptr<NamedMechanism>& named,
                          const py::dict& choice) { return found_mobility(named, choice); })
      .def("newton", [](const std::shared_ptr<NamedMechanism>& named, const py::dict& choice) {
        return found_newton(named, choice);
      });
  module.def(
      "mechanism_of_robot_text",
      [](const std::string& text, const std::optional<std::string>& tip,
         const std::vector<std::pair<std::string, double>>& held,
         const std::optional<Eigen::Matrix4d>& pose, const std::optional<std::string>& loops) {
        return of_robot({"robot", text}, tip, held, pose, loops);
      });
  module.def(
      "mechanism_of_robot_file",
      [](const std::string& path, const std::optional<std::string>& tip,
         const std::vector<std::pair<std::string, double>>& held,
         const std::optional<Eigen::Matrix4d>& pose, const std::optional<std::string>& loops) {
        return of_robot(read_source(path), tip, held, pose, loops);
      });
  module.def("mechanism_in_code", [](const std::string& text) {
    return std::make_shared<NamedMechanism>(
        NamedMechanism{"mechanism", read_mechanism_in_code(text)});
  });
  module.def("mechanism_of_file", [](const std::string& path) { return read(read_source(path)); });
  bind_closures(module);
  bind_motions(module);
  bind_sweeps(module);
}

}  // namespace moivre::python
