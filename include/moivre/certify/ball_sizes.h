// SPDX-License-Identifier: MIT
// How are the sizes of a million proved balls kept? In 16 bits a number: a double's exponent and
// the first five bits of its fraction.
//
//   radius   of a ball, each coordinate: rounded down
//   error    of the smaller ball about the same point in which the root lies: rounded up
// Numbers x >= 0, infinity among them, are rounded by less than x / 32, and what is smaller than
// 2^-1027 to 0 or 2^-1027: what was proved with them stays true as long as error < radius.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <valarray>

namespace moivre {

class BallSizes {
 public:
  BallSizes() = default;
  /// As many of each.
  BallSizes(std::span<const double> radii, std::span<const double> errors) {
    assign(radii, errors);
  }
  BallSizes(const BallSizes&) = default;
  BallSizes(BallSizes&&) noexcept = default;
  ~BallSizes() = default;
  // libstdc++'s valarray frees its memory twice where it is assigned to, or resized, and there is
  // no memory: it takes the new size and gives the old memory back before it asks for any.
  BallSizes& operator=(BallSizes other) noexcept {
    kept_.swap(other.kept_);
    return *this;
  }
  /// Allocates nothing where it had as many before.
  void assign(std::span<const double> radii, std::span<const double> errors);

  std::size_t dimension() const { return kept_.size() / 2; }
  double radius(std::size_t j) const { return number(kept_[2 * j]); }
  double error(std::size_t j) const { return number(kept_[2 * j + 1]); }
  void set(std::size_t j, double radius, double error);

  /// Of all coordinates; 0 of none.
  double largest_radius() const;
  double largest_error() const;
  /// error < radius in every coordinate.
  bool are_apart() const;
  friend bool operator==(const BallSizes& a, const BallSizes& b);

 private:
  static double number(std::uint16_t kept);

  std::valarray<std::uint16_t> kept_;  ///< radius and error of each coordinate
};

}  // namespace moivre
