// SPDX-License-Identifier: MIT
// A matrix looked at before it is taken as a displacement.
#include "poses.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "moivre/arms/rules.h"
#include "moivre/factorization/svd.h"

namespace moivre::python {
namespace {

// A rotation that was rounded to six digits is taken: each of its nine numbers is off by half a
// unit at most, the matrix by three times as much. A last row is taken likewise.
constexpr double kRounded = 1.5e-6;

// A matrix that is off by so little is a rotation but for rounding, and stays as it is.
constexpr double kRounding = 1e-12;

std::string refusal_of(double off, double most, bool is_mirrored, const std::string& remedy) {
  std::ostringstream text;
  text << "the upper left 3 x 3 block is no rotation";
  if (is_mirrored) {
    text << ": its frame is left-handed";
  } else {
    text << ": the nearest one is off by " << off << ", and may be by " << most;
    if (!remedy.empty()) text << "; " << remedy << " says that the pose is known no better";
    text << ". The nearest one is u @ vt: u, _, vt = numpy.linalg.svd(R)";
  }
  return text.str();
}

}  // namespace

Eigen::Isometry3d pose_of(const Eigen::Matrix4d& matrix, const std::string& where, double accuracy,
                          const std::string& remedy) {
  if (!matrix.allFinite()) throw std::invalid_argument(where + "a number is not finite");
  const Eigen::Matrix3d rotation = matrix.topLeftCorner<3, 3>();
  const Eigen::Matrix3d nearest = nearest_rotation(rotation);
  const double off = singular_values(rotation - nearest).maxCoeff();
  const double most = std::max(kRounded, accuracy);
  const bool is_mirrored = rotation.determinant() < 0;
  if (off > most || is_mirrored) {
    throw std::invalid_argument(where + refusal_of(off, most, is_mirrored, remedy));
  }
  const Eigen::RowVector4d last(0, 0, 0, 1);
  if ((matrix.row(3) - last).cwiseAbs().maxCoeff() > kRounded) {
    throw std::invalid_argument(where + "the last row is not 0 0 0 1");
  }
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = off > kRounding ? nearest : rotation;
  pose.translation() = matrix.topRightCorner<3, 1>();
  return pose;
}

}  // namespace moivre::python
