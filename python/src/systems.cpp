// SPDX-License-Identifier: MIT
// Systems for Python: from text, from exact numbers, from arrays of doubles; their roots as arrays
// and reports.
#include <pybind11/complex.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <stdexcept>

#include "arrays.h"
#include "bindings.h"
#include "choice.h"
#include "moivre/check/check.h"
#include "moivre/family/learn.h"
#include "moivre/family/members.h"
#include "moivre/family/parameter_homotopy.h"
#include "moivre/numeric/integer.h"
#include "moivre/numeric/invalid_input.h"
#include "moivre/polynomial/double_range.h"
#include "moivre/polynomial/read.h"
#include "moivre/report/check_report.h"
#include "moivre/report/info.h"
#include "moivre/report/solve_report.h"
#include "moivre/solver/cross_check.h"
#include "moivre/solver/digits.h"
#include "moivre/solver/filter.h"

namespace moivre::python {
namespace {

namespace py = pybind11;

using Complexes = py::array_t<Complex, py::array::c_style | py::array::forcecast>;
using Exponents = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;

Monomial monomial_of(const std::int64_t* exponents, std::size_t variables) {
  Monomial monomial;
  for (std::size_t k = 0; k < variables; ++k) {
    if (exponents[k] < 0 || exponents[k] > UINT32_MAX) {
      throw std::invalid_argument("an exponent of " + std::to_string(exponents[k]) +
                                  ": exponents are whole, from 0 to 4294967295");
    }
    if (exponents[k] == 0) continue;
    monomial.push_back({static_cast<std::uint32_t>(k), static_cast<std::uint32_t>(exponents[k])});
  }
  return monomial;
}

/// "-31/10", or "-3".
Rational rational_of(const std::string& text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) return ratio(Integer(text));
  return ratio(Integer(text.substr(0, slash)), Integer(text.substr(slash + 1)));
}

/// A sequence of (re, im), each such a text.
std::vector<Coefficient> exact_coefficients(const py::sequence& given) {
  std::vector<Coefficient> coefficients;
  for (const py::handle& each : given) {
    const auto [re, im] = each.cast<std::pair<std::string, std::string>>();
    coefficients.push_back({rational_of(re), rational_of(im)});
  }
  return coefficients;
}

Polynomial polynomial_of(const std::vector<Coefficient>& coefficients, const Exponents& exponents,
                         std::size_t variables) {
  const bool fits = exponents.ndim() == 2 &&
                    static_cast<std::size_t>(exponents.shape(0)) == coefficients.size() &&
                    static_cast<std::size_t>(exponents.shape(1)) == variables;
  if (!fits) {
    throw std::invalid_argument("exponents of shape (terms, variables) = (" +
                                std::to_string(coefficients.size()) + ", " +
                                std::to_string(variables) + ") are wanted");
  }
  TermMap terms;
  const std::int64_t* row = exponents.data();
  for (const Coefficient& c : coefficients) {
    Coefficient& sum = terms[monomial_of(row, variables)];
    sum = sum + c;
    row += variables;
  }
  return to_polynomial(std::move(terms));
}

/// equations: (coefficients, exponents) each.
System system_of_terms(std::vector<std::string> variables, const py::sequence& equations,
                       bool is_exact) {
  System system;
  system.variables = std::move(variables);
  system.is_exact = is_exact;
  for (const py::handle& each : equations) {
    const auto [coefficients, exponents] = each.cast<std::pair<py::sequence, Exponents>>();
    system.polynomials.push_back(
        polynomial_of(exact_coefficients(coefficients), exponents, system.variables.size()));
  }
  return held_by_double(std::move(system));
}

/// Its unknowns numbered anew.
Polynomial renumbered(Polynomial p, const std::vector<std::uint32_t>& place) {
  TermMap terms;
  for (Term& term : p.terms) {
    for (Power& power : term.monomial) power.variable = place[power.variable];
    std::sort(term.monomial.begin(), term.monomial.end());
    terms.emplace(std::move(term.monomial), std::move(term.coefficient));
  }
  return to_polynomial(std::move(terms));
}

/// The same system with unknowns of these names: old number k is place[k] now.
System renumbered(System system, std::vector<std::string> names,
                  const std::vector<std::uint32_t>& place) {
  system.variables = std::move(names);
  for (auto* list : {&system.polynomials, &system.denominators, &system.nudged}) {
    for (Polynomial& p : *list) p = renumbered(std::move(p), place);
  }
  for (Condition& condition : system.conditions) {
    condition.p = renumbered(std::move(condition.p), place);
  }
  for (VariableGroup& group : system.groups) {
    for (std::uint32_t& variable : group.variables) variable = place[variable];
    std::sort(group.variables.begin(), group.variables.end());
  }
  return system;
}

/// The same system with its unknowns in another order.
System in_order(const System& system, const std::vector<std::string>& names) {
  const std::size_t n = system.variables.size();
  std::vector<std::uint32_t> place(n);
  std::vector<bool> is_taken(n);
  for (std::size_t k = 0; k < names.size(); ++k) {
    const auto at = std::find(system.variables.begin(), system.variables.end(), names[k]);
    const auto old = static_cast<std::size_t>(at - system.variables.begin());
    if (old == n || is_taken[old]) {
      throw std::invalid_argument("variables: " + names[k] +
                                  (old == n ? " occurs in no equation" : " is named twice"));
    }
    is_taken[old] = true;
    place[old] = static_cast<std::uint32_t>(k);
  }
  if (names.size() != n) {
    const auto left = std::find(is_taken.begin(), is_taken.end(), false) - is_taken.begin();
    throw std::invalid_argument("variables: the unknown " +
                                system.variables[static_cast<std::size_t>(left)] + " is not named");
  }
  return renumbered(system, names, place);
}

/// A text's system in the unknowns that it was typed for, (name in the text, name) each; the text
/// need not have all of them. Its numbers are exact where the typist's were.
System in_unknowns(const System& typed,
                   const std::vector<std::pair<std::string, std::string>>& unknowns,
                   bool is_exact) {
  std::vector<std::string> names;
  std::vector<std::uint32_t> place(typed.variables.size());
  for (const auto& [in_text, name] : unknowns) {
    const auto at = std::find(typed.variables.begin(), typed.variables.end(), in_text);
    if (at != typed.variables.end()) {
      place[static_cast<std::size_t>(at - typed.variables.begin())] =
          static_cast<std::uint32_t>(names.size());
    }
    names.push_back(name);
  }
  System system = renumbered(typed, std::move(names), place);
  system.is_exact = system.is_exact && is_exact;
  require_unbroken(broken_rules(system));
  return system;
}

/// All that its roots depend on, for comparison.
std::string content_of(const System& f) {
  std::string text;
  const auto add = [&text](const auto& number) { text += number.str() + ' '; };
  for (const std::string& name : f.variables) text += name + '\n';
  for (const auto* list : {&f.polynomials, &f.denominators}) {
    for (const Polynomial& p : *list) {
      for (const Term& term : p.terms) {
        for (const Rational& part : {term.coefficient.re, term.coefficient.im}) {
          add(numerator(part));
          add(denominator(part));
        }
        for (const Power& power : term.monomial) {
          text += std::to_string(power.variable) + '^' + std::to_string(power.exponent) + ' ';
        }
        text += '\n';
      }
      text += ";\n";
    }
    text += ".\n";
  }
  for (const VariableGroup& group : f.groups) {
    for (const std::uint32_t variable : group.variables) text += std::to_string(variable) + ' ';
    text += group.is_homogeneous ? "homogeneous\n" : "\n";
  }
  return text;
}

bool is_asked(const py::dict& choice, const char* name) {
  return choice.contains(name) && option_value<bool>(name, choice[name]);
}

/// And conditions typed beside its equations.
System with_conditions(System system, const std::vector<std::string>& texts) {
  for (const std::string& text : texts) {
    for (Condition& condition : read_conditions({"where", text}, system.variables)) {
      system.conditions.push_back(std::move(condition));
    }
  }
  return system;
}

/// real, positive, nonzero, the system's conditions, where: texts, and box: (name, from, to) each.
/// Throws std::invalid_argument.
RootFilter filter_of(const py::dict& choice, const System& system) {
  RootFilter filter;
  filter.real = is_asked(choice, "real");
  filter.positive = is_asked(choice, "positive");
  filter.nonzero = is_asked(choice, "nonzero");
  filter.conditions = system.conditions;
  if (choice.contains("where")) {
    const auto typed = choice["where"].cast<std::vector<std::string>>();
    filter.conditions = with_conditions(system, typed).conditions;
  }
  if (!choice.contains("box")) return filter;
  for (const py::handle& each : choice["box"]) {
    const auto [name, from, to] = each.cast<std::tuple<std::string, double, double>>();
    filter.box.push_back({name, from, to});
  }
  std::vector<std::string> broken = broken_rules(filter, system.variables);
  for (std::string& rule : broken) rule.insert(0, "box: ");
  require_unbroken(broken);
  return filter;
}

/// What is asked for of the roots that a run has found.
struct Wanted {
  RootFilter filter;
  int digits = 0;
};

Wanted wanted_of(const py::dict& choice, const System& system) {
  Wanted wanted{filter_of(choice, system), 0};
  if (!choice.contains("digits")) return wanted;
  wanted.digits = option_value<int>("digits", choice["digits"]);
  require_digits(wanted.digits);
  return wanted;
}

void keep(const Wanted& wanted, Solved& run, const std::atomic<bool>& stop) {
  const int digits = wanted.digits > 0 ? wanted.digits : digits_that_part(run.system, run.result);
  if (digits > 0) give_digits(run.system, digits, run.result, stop);
  keep_wanted(wanted.filter, run.result);
}

Solved solved(const System& system, const py::dict& choice, const py::object& progress) {
  const Trackers trackers = make_trackers(choice);
  const Wanted wanted = wanted_of(choice, system);
  const bool is_checked = is_asked(choice, "cross_check");
  if (is_checked && trackers.other == nullptr) {
    throw std::invalid_argument("cross_check: this library was built with one tracker");
  }
  const SolveOptions chosen = solve_options(choice, trackers);
  return overseen(terms_of(choice, progress), [&](Oversight& oversight) {
    const SolveOptions options = overseen_by(oversight, chosen);
    const std::atomic<bool>& stop = oversight.stop();
    Solved run{system, solve(system, *trackers.chosen, options, stop)};
    if (is_checked && !stop) {
      cross_check(system, run.result, *trackers.chosen, *trackers.other, options, stop);
    }
    keep(wanted, run, stop);
    return run;
  });
}

std::vector<Point> points_of(const Complexes& given, std::size_t unknowns) {
  if (given.ndim() != 2 || static_cast<std::size_t>(given.shape(1)) != unknowns) {
    throw std::invalid_argument("start_points of shape (points, " + std::to_string(unknowns) +
                                ") are wanted");
  }
  std::vector<Point> points;
  for (py::ssize_t k = 0; k < given.shape(0); ++k) {
    points.emplace_back(given.data(k, 0), given.data(k, 0) + unknowns);
  }
  return points;
}

std::vector<NamedParameter> named(const std::vector<std::string>& parameters) {
  std::vector<NamedParameter> list;
  for (const std::string& name : parameters) list.push_back({name});
  return list;
}

/// The roots that known ones lead to.
Solved led_on(const System& system, const std::vector<std::string>& parameters,
              const py::sequence& from, const py::sequence& to, const Complexes& starts,
              const py::dict& choice, const py::object& progress) {
  const Trackers trackers = make_trackers(choice);
  const std::size_t unknowns = system.variables.size() - parameters.size();
  const ParameterProblem problem{system, parameters, exact_coefficients(from),
                                 points_of(starts, unknowns)};
  const ParameterValues end = exact_coefficients(to);
  System member = member_system(unlearned_family(system, named(parameters)), end);
  const Wanted wanted = wanted_of(choice, member);
  const SolveOptions chosen = solve_options(choice, trackers);
  return overseen(terms_of(choice, progress), [&](Oversight& oversight) {
    const SolveOptions options = overseen_by(oversight, chosen);
    Solved run{std::move(member), solve(problem, end, *trackers.chosen, options, oversight.stop())};
    keep(wanted, run, oversight.stop());
    return run;
  });
}

/// None where no comparison was made.
py::object comparison_of(const Solved& run) {
  if (!run.result.cross_check) return py::none();
  const CrossCheck& check = *run.result.cross_check;
  py::dict dict;
  dict["witness"] = check.witness;
  dict["common"] = check.common;
  dict["missed"] = check.missed;
  dict["unwitnessed"] = check.unwitnessed;
  dict["disagreements"] = check.disagreements.size();
  return dict;
}

Solved with_digits(const Solved& run, int digits, const py::dict& choice,
                   const py::object& progress) {
  require_digits(digits);
  return overseen(terms_of(choice, progress), [&](Oversight& oversight) {
    Solved more = run;
    give_digits(more.system, digits, more.result, oversight.stop());
    return more;
  });
}

py::list digits_of(const Solution& solution) {
  py::list list;
  for (const ComplexDecimal& x : solution.x_digits) list.append(py::make_tuple(x.re, x.im));
  return list;
}

py::dict root_arrays(const Solved& run) {
  const std::vector<Solution>& roots = run.result.solutions;
  const std::size_t n = run.system.variables.size();
  py::dict arrays;
  arrays["points"] = rows<Complex>(roots, n, [](const Solution& s) -> const Point& { return s.x; });
  arrays["real"] = column<bool>(roots, [](const Solution& s) { return s.real; });
  arrays["singular"] = column<bool>(roots, [](const Solution& s) { return s.singular; });
  arrays["multiplicity"] =
      column<std::int64_t>(roots, [](const Solution& s) { return s.multiplicity; });
  arrays["accuracy"] = column<double>(roots, [](const Solution& s) { return s.accuracy; });
  arrays["residual"] = column<double>(roots, [](const Solution& s) { return s.residual; });
  arrays["condition"] = column<double>(roots, [](const Solution& s) { return s.condition; });
  py::list certified, digits, on_boundary;
  for (const Solution& s : roots) {
    certified.append(optional_bool(s.certified));
    digits.append(digits_of(s));
    on_boundary.append(py::cast(s.on_boundary));
  }
  arrays["on_boundary"] = on_boundary;
  arrays["certified"] = certified;
  arrays["digits"] = digits;
  return arrays;
}

/// What is known of a system, asked for with the limits of a solve: JSON and text.
std::pair<std::string, std::string> inspected(const System& system, const std::string& name,
                                              const py::dict& choice) {
  return overseen(terms_of(choice, py::none()), [&](Oversight& oversight) {
    InspectOptions options;
    options.stop = &oversight.stop();
    const SystemInfo info = inspect(system, options);
    return std::pair{info_json(info, name), info_text(info, name)};
  });
}

/// A result of this system judged: JSON, text, whether no claim is refuted, and whether what is
/// said to be proved is.
std::tuple<std::string, std::string, bool, bool> judged(const System& system,
                                                        const std::string& name,
                                                        const std::string& result_name,
                                                        const std::string& result,
                                                        const py::dict& choice) {
  const Claims claims = read_claims({result_name, result}, system.variables);
  return overseen(terms_of(choice, py::none()), [&](Oversight& oversight) {
    const Judgement judgement = check(system, claims, oversight.stop());
    const JudgedFiles files{name, result_name};
    return std::tuple{check_json(judgement, files), check_text(judgement, files), judgement.holds(),
                      judgement.proofs_hold()};
  });
}

py::array set_points(const Solved& run) {
  return rows<Complex>(run.result.on_sets, run.system.variables.size(),
                       [](const Solution& s) -> const Point& { return s.x; });
}

py::list planes(const Solved& run) {
  py::list all;
  for (const CoordinatePlane& plane : run.result.planes) {
    py::dict one;
    one["zero"] = zero_names(plane, run.system.variables);
    one["dimension"] = plane.dimension;
    all.append(one);
  }
  return all;
}

}  // namespace

py::object completeness_of(const std::optional<RootCompleteness>& completeness) {
  if (!completeness) return py::none();
  return py::str(to_string(*completeness));
}

py::dict counts_of(const PathCounts& paths) {
  py::dict counts;
  counts["tracked"] = paths.tracked;
  counts["finite"] = paths.finite;
  counts["at_infinity"] = paths.at_infinity;
  counts["failed"] = paths.failed;
  return counts;
}

void bind_systems(py::module_& module) {
  py::class_<System>(module, "System")
      .def_readonly("variables", &System::variables)
      .def_property_readonly("equations", [](const System& f) { return f.polynomials.size(); })
      .def("in_order", &in_order)
      .def("in_unknowns", &in_unknowns)
      .def("content", &content_of)
      .def("text", [](const System& f) { return to_text(f, PolynomialFormat::phcpack); });
  module.def("system_of_text", [](const std::string& name, const std::string& text) {
    return read_system({name, text});
  });
  module.def("system_of_file",
             [](const std::string& path) { return read_system(read_source(path)); });
  module.def("system_of_terms", &system_of_terms);
  module.def("with_conditions", &with_conditions);

  py::class_<Solved>(module, "Solved")
      .def_property_readonly("complete", [](const Solved& run) { return run.result.complete; })
      .def_property_readonly("message", [](const Solved& run) { return run.result.message; })
      .def_property_readonly(
          "completeness",
          [](const Solved& run) { return completeness_of(run.result.completeness); })
      .def_property_readonly("variables", [](const Solved& run) { return run.system.variables; })
      .def_property_readonly("paths", [](const Solved& run) { return counts_of(run.result.paths); })
      .def_property_readonly("filtered", [](const Solved& run) { return run.result.filtered; })
      .def_property_readonly("cross_check", &comparison_of)
      .def("roots", &root_arrays)
      .def("set_points", &set_points)
      .def("planes", &planes)
      .def("with_digits", &with_digits)
      .def("json",
           [](const Solved& run, const std::string& file) { return solve_json(run.result, file); })
      .def("csv", [](const Solved& run) { return solve_csv(run.result); })
      .def("paths_csv", [](const Solved& run) { return paths_csv(run.result); })
      .def("phc", [](const Solved& run) { return solve_phc(run.result, run.system); })
      .def("text", [](const Solved& run, const std::string& file, bool all) {
        return solve_text(run.result, file, all ? ListedRoots::all : ListedRoots::real);
      });
  module.def("solve", &solved);
  module.def("led_on", &led_on);
  module.def("inspect", &inspected);
  module.def("judge", &judged);
}

}  // namespace moivre::python
