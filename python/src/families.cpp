// SPDX-License-Identifier: MIT
// Families for Python: learned, kept in files, and solved for many members at once.
#include <pybind11/complex.h>
#include <pybind11/stl.h>

#include "arrays.h"
#include "bindings.h"
#include "choice.h"
#include "moivre/family/family_file.h"
#include "moivre/family/learn.h"
#include "moivre/family/members.h"
#include "moivre/numeric/stopwatch.h"
#include "moivre/numeric/threads.h"
#include "moivre/report/family_report.h"

namespace moivre::python {
namespace {

namespace py = pybind11;

using Members = py::array_t<Complex, py::array::c_style | py::array::forcecast>;

/// Members of a family and their roots.
struct SolvedMembers {
  std::shared_ptr<const FamilyFile> file;
  std::vector<Point> members;
  std::vector<MemberRoots> roots;
  std::string tracker;
  OptionsInForce tracker_options;
  int threads = 1;
  double seconds = 0;

  const Family& family() const { return file->families.front(); }
};

std::shared_ptr<FamilyFile> file_of(Family family, const std::string& source) {
  auto file = std::make_shared<FamilyFile>();
  file->source = source;
  file->families.push_back(std::move(family));
  return file;
}

Family by_loops(Family family, const Tracker& tracker, const SolveOptions& options,
                bool is_always_tested, Oversight& oversight) {
  const auto pair = random_pair(family, options.seed);
  if (!pair) {
    throw std::invalid_argument(
        "monodromy: Newton's method in unknowns and parameters comes to no regular root of any "
        "member");
  }
  MonodromyOptions loops;
  loops.seed = options.seed;
  loops.threads = thread_count(options.threads);
  loops.certify = options.certify;
  loops.observations = options.observations;
  if (is_always_tested) loops.most_tested = loops.most_roots;
  loops.progress = [&](const LoopProgress& progress) { oversight.tell(progress.roots, 0); };
  return learn_by_monodromy(std::move(family), *pair, tracker, loops, oversight.stop());
}

/// parameters: (name, typical size) each.
std::shared_ptr<FamilyFile> learned(const System& system,
                                    const std::vector<std::pair<std::string, double>>& parameters,
                                    const std::string& source, bool monodromy, bool nonzero,
                                    const py::dict& choice, const py::object& progress) {
  std::vector<NamedParameter> named;
  for (const auto& [name, size] : parameters) named.push_back({name, size});
  Family family = unlearned_family(system, named);
  family.nonzero = nonzero;
  const Trackers trackers = make_trackers(choice);
  const bool is_always_tested =
      choice.contains("trace_test") && option_value<bool>("trace_test", choice["trace_test"]);
  if (is_always_tested && !monodromy) {
    throw std::invalid_argument("trace_test: needs monodromy=True");
  }
  const SolveOptions chosen = solve_options(choice, trackers);
  return overseen(terms_of(choice, progress), [&](Oversight& oversight) {
    const SolveOptions options = overseen_by(oversight, chosen);
    return file_of(
        monodromy
            ? by_loops(std::move(family), *trackers.chosen, options, is_always_tested, oversight)
            : learn(std::move(family), *trackers.chosen, options, oversight.stop()),
        source);
  });
}

std::vector<Point> members_of(const Family& family, const Members& given) {
  const std::size_t k = family.parameters();
  if (given.ndim() != 2 || static_cast<std::size_t>(given.shape(1)) != k) {
    throw std::invalid_argument("members of shape (N, " + std::to_string(k) + ") are wanted");
  }
  std::vector<Point> members;
  const Complex* from = given.data();
  for (py::ssize_t i = 0; i < given.shape(0); ++i, from += k) {
    for (std::size_t j = 0; j < k; ++j) {
      if (std::isfinite(from[j].real()) && std::isfinite(from[j].imag())) continue;
      throw std::invalid_argument("member " + std::to_string(i) + ": parameter " +
                                  family.parameter_names()[j] + " is not finite");
    }
    members.emplace_back(from, from + k);
  }
  return members;
}

SolvedMembers solved_members(const std::shared_ptr<FamilyFile>& file, const Members& given,
                             const py::dict& choice, const py::object& progress) {
  const Trackers trackers = make_trackers(choice);
  SolvedMembers run;
  run.file = file;
  run.members = members_of(run.family(), given);
  SolveOptions chosen = solve_options(choice, trackers);
  chosen.threads = thread_count(chosen.threads);
  return overseen(terms_of(choice, progress), [&](Oversight& oversight) {
    const Stopwatch watch;
    const SolveOptions options = overseen_by(oversight, chosen);
    run.roots =
        solve_members(run.family(), run.members, *trackers.chosen, options, oversight.stop());
    run.tracker = trackers.chosen->kind();
    run.tracker_options = trackers.chosen->options_in_force();
    run.threads = options.threads;
    run.seconds = watch.total();
    return std::move(run);
  });
}

Solved solved_member(const FamilyFile& file, const std::string& values, const py::dict& choice,
                     const py::object& progress) {
  const Family& family = file.families.front();
  const ParameterValues p = values_at(family, values);
  const Trackers trackers = make_trackers(choice);
  SolveOptions chosen = solve_options(choice, trackers);
  chosen.threads = thread_count(chosen.threads);
  return overseen(terms_of(choice, progress), [&](Oversight& oversight) {
    const SolveOptions options = overseen_by(oversight, chosen);
    return Solved{member_system(family, p),
                  solve_member(family, p, *trackers.chosen, options, oversight.stop())};
  });
}

/// All roots, member after member.
py::dict member_arrays(const SolvedMembers& run) {
  std::vector<const MemberRoot*> roots;
  std::vector<std::int64_t> member;
  for (std::size_t k = 0; k < run.roots.size(); ++k) {
    for (const MemberRoot& root : run.roots[k].roots) {
      roots.push_back(&root);
      member.push_back(static_cast<std::int64_t>(k));
    }
  }
  py::dict arrays;
  arrays["points"] = rows<Complex>(roots, run.family().unknowns(),
                                   [](const MemberRoot* r) -> const Point& { return r->x; });
  arrays["member"] = column<std::int64_t>(member, [](std::int64_t k) { return k; });
  arrays["real"] = column<bool>(roots, [](const MemberRoot* r) { return r->real; });
  arrays["multiplicity"] =
      column<std::int64_t>(roots, [](const MemberRoot* r) { return r->multiplicity; });
  arrays["accuracy"] = column<double>(roots, [](const MemberRoot* r) { return r->accuracy; });
  arrays["certified"] =
      column<bool>(roots, [](const MemberRoot* r) { return r->certified.value_or(false); });
  arrays["counts"] =
      column<std::int64_t>(run.roots, [](const MemberRoots& m) { return m.roots.size(); });
  arrays["complete"] = column<bool>(run.roots, [](const MemberRoots& m) { return m.complete; });
  py::list completeness;
  for (const MemberRoots& m : run.roots) completeness.append(completeness_of(m.completeness));
  arrays["completeness"] = completeness;
  return arrays;
}

MembersRun report_of(const SolvedMembers& run, const std::string& name, const std::string& table) {
  return {run.family(), run.members,         run.roots,   name,       table,
          run.tracker,  run.tracker_options, run.threads, run.seconds};
}

std::shared_ptr<FamilyFile> loaded(const std::string& path) {
  auto file = std::make_shared<FamilyFile>(load_family(path));
  if (file->kind == kPolynomialsKind) return file;
  throw std::invalid_argument(path + ": these are the families of a mechanism, not of a system");
}

}  // namespace

void bind_families(py::module_& module) {
  py::class_<FamilyFile, std::shared_ptr<FamilyFile>>(module, "FamilyFile")
      .def_property_readonly(
          "unknowns", [](const FamilyFile& file) { return file.families.front().unknown_names(); })
      .def_property_readonly(
          "parameters",
          [](const FamilyFile& file) { return file.families.front().parameter_names(); })
      .def_property_readonly(
          "roots", [](const FamilyFile& file) { return file.families.front().roots.size(); })
      .def_property_readonly(
          "complete",
          [](const FamilyFile& file) { return file.families.front().learning.complete; })
      .def_property_readonly(
          "standing",
          [](const FamilyFile& file) { return file.families.front().learning.standing; })
      .def("save", [](const FamilyFile& file, const std::string& path) { save_family(file, path); })
      .def("text", [](const FamilyFile& file,
                      const std::string& name) { return family_report_text(file, name); })
      .def("json", [](const FamilyFile& file, const std::string& name) {
        return family_report_json(file, name, "family info");
      });
  module.def("family_learn", &learned);
  module.def("family_load", &loaded);
  module.def("family_member", &solved_member);

  py::class_<SolvedMembers>(module, "SolvedMembers")
      .def("roots", &member_arrays)
      .def("json",
           [](const SolvedMembers& run, const std::string& name, const std::string& table) {
             return members_json(report_of(run, name, table));
           })
      .def("csv", [](const SolvedMembers& run, const std::string& name,
                     const std::string& table) { return members_csv(report_of(run, name, table)); })
      .def("text", [](const SolvedMembers& run, const std::string& name, const std::string& table) {
        return members_text(report_of(run, name, table));
      });
  module.def("family_members", &solved_members);
}

}  // namespace moivre::python
