// SPDX-License-Identifier: MIT
// Robot arms for Python: all joint values for many poses as one array, and the way back.
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "arrays.h"
#include "bindings.h"
#include "choice.h"
#include "moivre/arm_report/arm_report.h"
#include "moivre/arms/arm_closures.h"
#include "moivre/arms/posture.h"
#include "moivre/numeric/stopwatch.h"
#include "moivre/urdf/read.h"

namespace moivre::python {
namespace {

namespace py = pybind11;

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
using RowMajor4 = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;

// So many postures a general arm has at most; a result has room for more where there are more.
constexpr std::size_t kMostPostures = 16;
// A rotation that was rounded to six digits is taken, and made exactly one; so is a last row.
constexpr double kRounded = 1e-6;

/// The arm and where it was read.
struct NamedArm {
  std::string file;
  Arm arm;
};

/// Poses and all their postures.
struct Postures {
  std::shared_ptr<const NamedArm> of;
  std::vector<ArmResult> results;  ///< fewer than poses where the run was interrupted
  std::size_t poses = 0;
  bool is_list = false;
  double seconds = 0;

  ArmReport report() const {
    ArmReport report;
    report.file = of->file;
    report.arm = of->arm;
    report.results = results;
    report.is_list = is_list;
    report.total_s = seconds;
    return report;
  }
};

Eigen::Isometry3d pose_of(const double* entries, py::ssize_t number) {
  const RowMajor4 matrix = Eigen::Map<const RowMajor4>(entries);
  const std::string where = "pose " + std::to_string(number) + ": ";
  if (!matrix.allFinite()) throw std::invalid_argument(where + "a number is not finite");
  const Eigen::Matrix3d rotation = matrix.topLeftCorner<3, 3>();
  const double off =
      (rotation.transpose() * rotation - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (off > kRounded || rotation.determinant() < 0) {
    std::ostringstream text;
    text << where << "the upper left 3 x 3 block is no rotation";
    if (off > kRounded) {
      text << ": R^T R is off the unit matrix by " << off << ", and may be by " << kRounded
           << ". Of a rounded one u @ vt is the nearest: u, _, vt = numpy.linalg.svd(R)";
    }
    throw std::invalid_argument(text.str());
  }
  const Eigen::RowVector4d last(0, 0, 0, 1);
  if ((matrix.row(3) - last).cwiseAbs().maxCoeff() > kRounded) {
    throw std::invalid_argument(where + "the last row is not 0 0 0 1");
  }
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::Quaterniond(rotation).normalized().toRotationMatrix();
  pose.translation() = matrix.topRightCorner<3, 1>();
  return pose;
}

std::vector<Eigen::Isometry3d> poses_of(const Doubles& given) {
  if (given.ndim() != 3 || given.shape(1) != 4 || given.shape(2) != 4) {
    throw std::invalid_argument("poses of shape (4, 4) or (N, 4, 4) are wanted");
  }
  std::vector<Eigen::Isometry3d> poses;
  poses.reserve(static_cast<std::size_t>(given.shape(0)));
  for (py::ssize_t k = 0; k < given.shape(0); ++k) poses.push_back(pose_of(given.data(k, 0, 0), k));
  return poses;
}

Postures postures(const std::shared_ptr<NamedArm>& arm, const Doubles& given, bool is_list,
                  const py::dict& choice, const py::object& progress) {
  const Trackers trackers = make_trackers(choice);
  const std::vector<Eigen::Isometry3d> poses = poses_of(given);
  const SolveOptions chosen = solve_options(choice, trackers);
  return overseen(progress, [&](Oversight& oversight) {
    const Stopwatch watch;
    const SolveOptions options = overseen_by(oversight, chosen);
    Postures run{arm, {}, poses.size(), is_list, 0};
    run.results = find_arm_closures(arm->arm, poses, *trackers.chosen, options, oversight.stop());
    run.seconds = watch.total();
    return run;
  });
}

/// write(closure, row): the row of each posture in an array (poses, width, joints) of NaN.
template <class Write>
py::array_t<double> padded(const Postures& run, std::size_t width, Write write) {
  const std::size_t joints = run.of->arm.joints.size();
  py::array_t<double> array(std::vector<py::ssize_t>{static_cast<py::ssize_t>(run.poses),
                                                     static_cast<py::ssize_t>(width),
                                                     static_cast<py::ssize_t>(joints)});
  double* const begin = array.mutable_data();
  std::fill_n(begin, run.poses * width * joints, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t k = 0; k < run.results.size(); ++k) {
    double* row = begin + k * width * joints;
    for (const ArmClosure& closure : run.results[k].closures) {
      write(closure, row);
      row += joints;
    }
  }
  return array;
}

py::dict posture_arrays(const Postures& run) {
  std::size_t width = kMostPostures;
  for (const ArmResult& result : run.results) width = std::max(width, result.closures.size());
  py::array_t<std::int64_t> counts(static_cast<py::ssize_t>(run.poses));
  py::array_t<bool> complete(static_cast<py::ssize_t>(run.poses));
  py::array_t<bool> moves(static_cast<py::ssize_t>(run.poses));
  for (std::size_t k = 0; k < run.poses; ++k) {
    const bool is_done = k < run.results.size();
    const auto at = static_cast<py::ssize_t>(k);
    counts.mutable_at(at) = is_done ? static_cast<std::int64_t>(run.results[k].closures.size()) : 0;
    complete.mutable_at(at) = is_done && run.results[k].complete;
    moves.mutable_at(at) = is_done && !run.results[k].moves.empty();
  }
  const auto copy = [](const Eigen::VectorXd& values, double* row) {
    std::copy(values.data(), values.data() + values.size(), row);
  };
  py::dict arrays;
  arrays["values"] =
      padded(run, width, [&](const ArmClosure& c, double* row) { copy(c.values, row); });
  arrays["in_limits"] =
      padded(run, width, [&](const ArmClosure& c, double* row) { copy(c.in_limits, row); });
  arrays["counts"] = counts;
  arrays["complete"] = complete;
  arrays["moves"] = moves;
  return arrays;
}

/// q: (joints,), or (N, joints); the tip's pose: (4, 4), or (N, 4, 4).
Doubles forward(const NamedArm& named, const Doubles& q) {
  const std::size_t joints = named.arm.joints.size();
  const bool is_one = q.ndim() == 1;
  if (q.ndim() < 1 || q.ndim() > 2 || static_cast<std::size_t>(q.shape(q.ndim() - 1)) != joints) {
    throw std::invalid_argument("joint values of shape (" + std::to_string(joints) + ",) or (N, " +
                                std::to_string(joints) + ") are wanted");
  }
  const py::ssize_t count = is_one ? 1 : q.shape(0);
  Doubles poses(is_one ? std::vector<py::ssize_t>{4, 4} : std::vector<py::ssize_t>{count, 4, 4});
  for (py::ssize_t k = 0; k < count; ++k) {
    const double* const row = q.data() + k * static_cast<py::ssize_t>(joints);
    const Eigen::VectorXd values =
        Eigen::Map<const Eigen::VectorXd>(row, static_cast<Eigen::Index>(joints));
    if (!values.allFinite()) throw std::invalid_argument("a joint value is not finite");
    Eigen::Map<RowMajor4>(poses.mutable_data() + 16 * k) =
        forward_kinematics(named.arm, values).matrix();
  }
  return poses;
}

std::shared_ptr<NamedArm> arm_of(const Source& source, const std::optional<std::string>& base,
                                 const std::optional<std::string>& tip,
                                 const std::vector<std::pair<std::string, double>>& held) {
  ArmChoice choice{base, tip, {}};
  for (const auto& [joint, value] : held) choice.held.push_back({joint, value});
  return std::make_shared<NamedArm>(NamedArm{source.name, make_arm(read_urdf(source), choice)});
}

py::list limits_of(const NamedArm& named) {
  py::list limits;
  for (const ArmJoint& joint : named.arm.joints) {
    if (joint.limits) {
      limits.append(py::make_tuple(joint.limits->lower, joint.limits->upper));
    } else {
      limits.append(py::none());
    }
  }
  return limits;
}

std::vector<std::string> names_of(const Postures& run, std::size_t pose) {
  std::vector<std::string> names;
  if (pose >= run.results.size()) return names;
  for (const ArmClosure& closure : run.results[pose].closures) {
    names.push_back(to_string(posture_of(run.of->arm, closure.values)));
  }
  return names;
}

}  // namespace

void bind_arms(py::module_& module) {
  py::class_<NamedArm, std::shared_ptr<NamedArm>>(module, "Arm")
      .def_property_readonly("robot", [](const NamedArm& named) { return named.arm.robot; })
      .def_property_readonly("base", [](const NamedArm& named) { return named.arm.base; })
      .def_property_readonly("tip", [](const NamedArm& named) { return named.arm.tip; })
      .def_property_readonly("joints",
                             [](const NamedArm& named) {
                               std::vector<std::string> names;
                               for (const ArmJoint& joint : named.arm.joints)
                                 names.push_back(joint.name);
                               return names;
                             })
      .def_property_readonly("limits", &limits_of)
      .def("fk", &forward);
  module.def("arm_of_file", [](const std::string& path, const std::optional<std::string>& base,
                               const std::optional<std::string>& tip,
                               const std::vector<std::pair<std::string, double>>& held) {
    return arm_of(read_source(path), base, tip, held);
  });
  module.def("arm_of_text", [](const std::string& text, const std::optional<std::string>& base,
                               const std::optional<std::string>& tip,
                               const std::vector<std::pair<std::string, double>>& held) {
    return arm_of({"robot", text}, base, tip, held);
  });
  module.def("arm_ik", &postures);

  py::class_<Postures>(module, "Postures")
      .def_readonly("seconds", &Postures::seconds)
      .def("arrays", &posture_arrays)
      .def("names", &names_of)
      .def("json", [](const Postures& run) { return arm_json(run.report()); })
      .def("text", [](const Postures& run) { return arm_text(run.report()); })
      .def("svg", [](const Postures& run) { return arm_svg(run.report(), false); })
      .def("html", [](const Postures& run) { return arm_html(run.report(), false); });
}

}  // namespace moivre::python
