// SPDX-License-Identifier: MIT
// A matrix looked at before it is taken as a displacement.
#include "poses.h"

#include <sstream>
#include <stdexcept>

namespace moivre::python {
namespace {

// A rotation that was rounded to six digits is taken, and made exactly one; so is a last row.
constexpr double kRounded = 1e-6;

}  // namespace

Eigen::Isometry3d pose_of(const Eigen::Matrix4d& matrix, const std::string& where) {
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

}  // namespace moivre::python
