// SPDX-License-Identifier: MIT
// The upper bits of a double, of which all numbers here have the same sign.
#include "moivre/certify/ball_sizes.h"

#include <algorithm>
#include <bit>

namespace moivre {
namespace {

// Bits of the fraction that are left out; the sign, above the others, is 0.
constexpr int kBitsLeftOut = 47;

std::uint16_t rounded_down(double x) {
  return static_cast<std::uint16_t>(std::bit_cast<std::uint64_t>(x) >> kBitsLeftOut);
}

std::uint16_t rounded_up(double x) {
  constexpr std::uint64_t kAll = (std::uint64_t{1} << kBitsLeftOut) - 1;
  return static_cast<std::uint16_t>((std::bit_cast<std::uint64_t>(x) + kAll) >> kBitsLeftOut);
}

}  // namespace

void BallSizes::assign(std::span<const double> radii, std::span<const double> errors) {
  if (dimension() != radii.size()) kept_ = std::valarray<std::uint16_t>(2 * radii.size());
  for (std::size_t j = 0; j < radii.size(); ++j) set(j, radii[j], errors[j]);
}

void BallSizes::set(std::size_t j, double radius, double error) {
  kept_[2 * j] = rounded_down(radius);
  kept_[2 * j + 1] = rounded_up(error);
}

double BallSizes::largest_radius() const {
  double largest = 0;
  for (std::size_t j = 0; j < dimension(); ++j) largest = std::max(largest, radius(j));
  return largest;
}

double BallSizes::largest_error() const {
  double largest = 0;
  for (std::size_t j = 0; j < dimension(); ++j) largest = std::max(largest, error(j));
  return largest;
}

bool BallSizes::are_apart() const {
  for (std::size_t j = 0; j < dimension(); ++j) {
    if (!(error(j) < radius(j))) return false;
  }
  return true;
}

bool operator==(const BallSizes& a, const BallSizes& b) {
  if (a.dimension() != b.dimension()) return false;
  for (std::size_t k = 0; k < a.kept_.size(); ++k) {
    if (a.kept_[k] != b.kept_[k]) return false;
  }
  return true;
}

double BallSizes::number(std::uint16_t kept) {
  return std::bit_cast<double>(std::uint64_t{kept} << kBitsLeftOut);
}

}  // namespace moivre
