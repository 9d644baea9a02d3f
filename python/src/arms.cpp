// SPDX-License-Identifier: MIT
// Robot arms for Python: all joint values for many poses as one array, and the way back.
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "arrays.h"
#include "bindings.h"
#include "choice.h"
#include "moivre/arm_report/arm_report.h"
#include "moivre/arms/arm_closures.h"
#include "moivre/arms/posture.h"
#include "moivre/arms/turns.h"
#include "moivre/numeric/invalid_input.h"
#include "moivre/numeric/stopwatch.h"
#include "moivre/urdf/read.h"
#include "poses.h"

namespace moivre::python {
namespace {

namespace py = pybind11;

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using RowMajor4 = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;

// So many postures a general arm has at most; a result has room for more where there are more.
constexpr std::size_t kMostPostures = 16;

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
  std::optional<Eigen::VectorXd> stands = std::nullopt;
  bool has_all_turns = false;
  double seconds = 0;

  ArmReport report() const {
    ArmReport report;
    report.file = of->file;
    report.arm = of->arm;
    report.results = results;
    report.is_list = is_list;
    report.stands = stands;
    report.has_all_turns = has_all_turns;
    report.total_s = seconds;
    return report;
  }
};

std::vector<TypedPose> poses_of(const Doubles& given, double accuracy) {
  if (given.ndim() != 3 || given.shape(1) != 4 || given.shape(2) != 4) {
    throw std::invalid_argument("poses of shape (4, 4) or (N, 4, 4) are wanted");
  }
  std::vector<TypedPose> poses;
  poses.reserve(static_cast<std::size_t>(given.shape(0)));
  for (py::ssize_t k = 0; k < given.shape(0); ++k) {
    const RowMajor4 matrix = Eigen::Map<const RowMajor4>(given.data(k, 0, 0));
    poses.push_back(
        {pose_of(matrix, "pose " + std::to_string(k) + ": ", accuracy, "a larger pose_accuracy="),
         accuracy});
  }
  return poses;
}

/// pose_accuracy of the choice; 0 where there is none.
double pose_accuracy(const py::dict& choice) {
  if (!choice.contains("pose_accuracy")) return 0;
  const auto accuracy = option_value<double>("pose_accuracy", choice["pose_accuracy"]);
  if (accuracy >= 0 && std::isfinite(accuracy)) return accuracy;
  throw std::invalid_argument("pose_accuracy: metres and radians, 0 or more and finite");
}

/// nearest of the choice.
std::optional<Eigen::VectorXd> standing(const py::dict& choice, const Arm& arm) {
  if (!choice.contains("nearest")) return std::nullopt;
  const auto stands = choice["nearest"].cast<Eigen::VectorXd>();
  try {
    require_standing(arm, stands);
  } catch (const InvalidInput& refusal) {
    throw std::invalid_argument(std::string("nearest: ") + refusal.what());
  }
  return stands;
}

/// limits of the choice: "wrap".
bool wraps(const py::dict& choice, const Arm& arm) {
  if (!choice.contains("limits")) return false;
  if (option_value<std::string>("limits", choice["limits"]) != "wrap") {
    throw std::invalid_argument("limits: \"wrap\" is the only word that it takes");
  }
  try {
    require_few_turns(arm);
  } catch (const InvalidInput& refusal) {
    throw std::invalid_argument(std::string("limits: ") + refusal.what());
  }
  return true;
}

Postures postures(const std::shared_ptr<NamedArm>& arm, const Doubles& given, bool is_list,
                  const py::dict& choice, const py::object& progress) {
  const Trackers trackers = make_trackers(choice);
  const std::vector<TypedPose> poses = poses_of(given, pose_accuracy(choice));
  const SolveOptions chosen = solve_options(choice, trackers);
  Postures run{arm, {}, poses.size(), is_list, standing(choice, arm->arm), wraps(choice, arm->arm)};
  return overseen(terms_of(choice, progress), [&](Oversight& oversight) {
    const Stopwatch watch;
    const SolveOptions options = overseen_by(oversight, chosen);
    run.results = find_arm_closures(arm->arm, poses, *trackers.chosen, options, oversight.stop());
    if (run.stands) {
      for (ArmResult& result : run.results) {
        sort_by_distance(arm->arm, *run.stands, result.closures);
      }
    }
    run.seconds = watch.total();
    return std::move(run);
  });
}

/// write(closure, row): the row of each posture in an array (poses, width, numbers) of NaN; (poses,
/// width) of one number.
template <class Write>
py::array_t<double> padded(const Postures& run, std::size_t width, std::size_t numbers,
                           Write write) {
  std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(run.poses),
                                 static_cast<py::ssize_t>(width)};
  if (numbers != 1) shape.push_back(static_cast<py::ssize_t>(numbers));
  py::array_t<double> array(shape);
  double* const begin = array.mutable_data();
  std::fill_n(begin, run.poses * width * numbers, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t k = 0; k < run.results.size(); ++k) {
    double* row = begin + k * width * numbers;
    for (const ArmClosure& closure : run.results[k].closures) {
      write(closure, row);
      row += numbers;
    }
  }
  return array;
}

std::size_t width_of(const Postures& run) {
  std::size_t width = kMostPostures;
  for (const ArmResult& result : run.results) width = std::max(width, result.closures.size());
  return width;
}

/// (poses, width, joints): the joint values of each posture. Where there is one joint, too, the
/// array has an axis of joints.
py::array_t<double> joint_array(const Postures& run, const Eigen::VectorXd ArmClosure::*values) {
  const std::size_t width = width_of(run);
  const std::size_t joints = run.of->arm.joints.size();
  const auto copy = [&](const ArmClosure& closure, double* row) {
    std::copy_n((closure.*values).data(), joints, row);
  };
  return padded(run, width, joints, copy)
      .reshape(std::vector<py::ssize_t>{static_cast<py::ssize_t>(run.poses),
                                        static_cast<py::ssize_t>(width),
                                        static_cast<py::ssize_t>(joints)});
}

/// (poses, width): read(closure), a number.
template <class Read>
py::array_t<double> number_array(const Postures& run, Read read) {
  return padded(run, width_of(run), 1, [&](const ArmClosure& c, double* row) { *row = read(c); });
}

/// Of each posture, where the arm stands somewhere.
py::object distances(const Postures& run) {
  if (!run.stands) return py::none();
  return number_array(run, [&](const ArmClosure& c) {
    return distance_from(run.of->arm, c.in_limits, *run.stands);
  });
}

/// Arrays with a row for each posture, each made when it is asked for: those of 100 000 poses fill
/// 200 MB, and to touch these takes longer than Ctrl-C may.
void bind_posture_arrays(py::class_<Postures>& postures) {
  const auto numbers = [&](const char* name, auto read) {
    postures.def(name, [read](const Postures& run) { return number_array(run, read); });
  };
  postures.def("values", [](const Postures& run) { return joint_array(run, &ArmClosure::values); });
  postures.def("in_limits",
               [](const Postures& run) { return joint_array(run, &ArmClosure::in_limits); });
  numbers("residual", [](const ArmClosure& c) { return c.residual; });
  numbers("smallest_singular_value", [](const ArmClosure& c) { return c.smallest_singular_value; });
  numbers("moved_by_digits", [](const ArmClosure& c) { return c.moved_by_digits; });
  numbers("within_digits", [](const ArmClosure& c) { return c.within_digits ? 1 : 0; });
  postures.def("distance", &distances);
}

/// What is known of each pose: (poses).
py::dict pose_arrays(const Postures& run) {
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
  py::dict arrays;
  arrays["counts"] = counts;
  arrays["complete"] = complete;
  arrays["moves"] = moves;
  return arrays;
}

/// Throws std::invalid_argument unless q is (joints,) or (N, joints), and finite.
void require_joint_values(const NamedArm& named, const Doubles& q) {
  const std::size_t joints = named.arm.joints.size();
  if (q.ndim() < 1 || q.ndim() > 2 || static_cast<std::size_t>(q.shape(q.ndim() - 1)) != joints) {
    throw std::invalid_argument("joint values of shape (" + std::to_string(joints) + ",) or (N, " +
                                std::to_string(joints) + ") are wanted");
  }
  if (!std::all_of(q.data(), q.data() + q.size(), [](double x) { return std::isfinite(x); })) {
    throw std::invalid_argument("a joint value is not finite");
  }
}

Eigen::VectorXd joint_values(const NamedArm& named, const Doubles& q, py::ssize_t row) {
  const std::size_t joints = named.arm.joints.size();
  return Eigen::Map<const Eigen::VectorXd>(q.data() + row * static_cast<py::ssize_t>(joints),
                                           static_cast<Eigen::Index>(joints));
}

/// q: (joints,) or (N, joints), poses (1, 4, 4) or (N, 4, 4): metres and radians, (N, 2).
py::array_t<double> misfits(const NamedArm& named, const Doubles& q, const Doubles& given) {
  // What is measured here has no accuracy of its own: two decimals of a rotation are enough.
  constexpr double kTwoDecimals = 1e-2;
  require_joint_values(named, q);
  const std::vector<TypedPose> poses = poses_of(given, kTwoDecimals);
  const py::ssize_t count = q.ndim() == 1 ? 1 : q.shape(0);
  const auto asked = std::max(count, std::ssize(poses));
  if ((count != 1 && count != asked) || (std::ssize(poses) != 1 && std::ssize(poses) != asked)) {
    throw std::invalid_argument("as many poses as joint values are wanted, or one of either");
  }
  py::array_t<double> array({asked, py::ssize_t{2}});
  for (py::ssize_t k = 0; k < asked; ++k) {
    const PoseMisfit miss =
        misfit_of(named.arm, poses[poses.size() == 1 ? 0 : static_cast<std::size_t>(k)].pose,
                  joint_values(named, q, count == 1 ? 0 : k));
    array.mutable_at(k, 0) = miss.position;
    array.mutable_at(k, 1) = miss.rotation;
  }
  return array;
}

/// q: (joints,), or (N, joints); the tip's pose: (4, 4), or (N, 4, 4).
Doubles forward(const NamedArm& named, const Doubles& q) {
  require_joint_values(named, q);
  const bool is_one = q.ndim() == 1;
  const py::ssize_t count = is_one ? 1 : q.shape(0);
  Doubles poses(is_one ? std::vector<py::ssize_t>{4, 4} : std::vector<py::ssize_t>{count, 4, 4});
  for (py::ssize_t k = 0; k < count; ++k) {
    Eigen::Map<RowMajor4>(poses.mutable_data() + 16 * k) =
        forward_kinematics(named.arm, joint_values(named, q, k)).matrix();
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

/// Of each posture of a pose every choice of whole turns that the limits allow.
std::vector<Eigen::MatrixXd> turns_of(const Postures& run, std::size_t pose) {
  std::vector<Eigen::MatrixXd> turns;
  if (pose >= run.results.size()) return turns;
  for (const ArmClosure& closure : run.results[pose].closures) {
    const std::vector<Eigen::VectorXd> all = all_turns(run.of->arm, closure.in_limits);
    Eigen::MatrixXd& rows = turns.emplace_back(std::ssize(all), closure.values.size());
    for (Eigen::Index k = 0; k < rows.rows(); ++k) rows.row(k) = all[static_cast<std::size_t>(k)];
  }
  return turns;
}

Eigen::VectorXd placed(const Arm& arm, Eigen::VectorXd values) {
  place_in_limits(arm, values);
  return values;
}

Eigen::MatrixXd samples_of(const Arm& arm, const SelfMotion& motion) {
  Eigen::MatrixXd rows(std::ssize(motion.samples), motion.values.size());
  for (Eigen::Index k = 0; k < rows.rows(); ++k) {
    rows.row(k) = placed(arm, motion.samples[static_cast<std::size_t>(k)]);
  }
  return rows;
}

Vector6 row_of(const Twist& twist) {
  Vector6 row;
  row << twist.translation, twist.rotation;
  return row;
}

py::list motions_of(const Postures& run, std::size_t pose) {
  py::list list;
  if (pose >= run.results.size()) return list;
  for (const SelfMotion& motion : run.results[pose].moves) {
    py::list relations;
    for (const JointRelation& relation : motion.relations) {
      relations.append(py::make_tuple(relation.factors, relation.value));
    }
    py::dict each;
    each["dimension"] = motion.dimension;
    each["q"] = placed(run.of->arm, motion.values);
    each["directions"] = motion.directions;
    each["lost"] = row_of(motion.lost);
    each["relations"] = relations;
    each["samples"] = samples_of(run.of->arm, motion);
    each["closes"] = motion.closes;
    each["misfit"] = motion.misfit;
    each["within_digits"] = motion.within_digits;
    list.append(each);
  }
  return list;
}

/// Whether the joint values are on a set of a pose.
bool is_on_motion(const Postures& run, std::size_t pose, std::size_t motion,
                  const Eigen::VectorXd& q, double within) {
  const ArmResult& result = run.results.at(pose);
  return contains(run.of->arm, result, result.moves.at(motion), q, within);
}

/// Of the posture that comes nearest to a pose which none holds; None elsewhere.
py::object nearest_of(const Postures& run, std::size_t pose) {
  if (pose >= run.results.size() || !run.results[pose].nearest) return py::none();
  const NearestPosture& nearest = *run.results[pose].nearest;
  py::dict dict;
  dict["q"] = placed(run.of->arm, nearest.values);
  dict["position"] = nearest.apart.position;
  dict["rotation"] = nearest.apart.rotation;
  return dict;
}

std::string message_of(const Postures& run, std::size_t pose) {
  return pose < run.results.size() ? run.results[pose].message : "not begun";
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
      .def("fk", &forward)
      .def("misfits", &misfits);
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

  py::class_<Postures> bound(module, "Postures");
  bind_posture_arrays(bound);
  bound.def_readonly("seconds", &Postures::seconds)
      .def("pose_arrays", &pose_arrays)
      .def("names", &names_of)
      .def("turns", &turns_of)
      .def("motions", &motions_of)
      .def("nearest", &nearest_of)
      .def("is_on_motion", &is_on_motion)
      .def("message", &message_of)
      .def("json", [](const Postures& run) { return arm_json(run.report()); })
      .def("text", [](const Postures& run) { return arm_text(run.report()); })
      .def("csv",
           [](const Postures& run, bool in_degrees) { return arm_csv(run.report(), in_degrees); })
      .def("svg",
           [](const Postures& run, bool three_views) {
             return arm_svg(run.report(), false, three_views ? Views::three : Views::standing);
           })
      .def("html", [](const Postures& run) { return arm_html(run.report(), false); });
}

}  // namespace moivre::python
