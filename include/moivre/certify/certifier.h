// SPDX-License-Identifier: MIT
// Is there provably exactly one root near this point, and is it real? Krawczyk's operator in balls,
// on the exact system.
//
//   K(B) = m - Y F(m) + (I - Y J(B)) (B - m),   Y near J(m)^{-1}, any matrix
//   kappa_j = |Y F(m)|_j + sum_k |I - Y J(B)|_jk rho_k < rho_j for all j   ==>   exactly one root
//   in B, within kappa of m
//
// B: the polydisc of radii rho around m. Proof, in the norm max_j |v_j| / rho_j: the inequality
// makes x -> x - Y F(x) a contraction of B into itself (mean-value form, J(B) a convex set). Y is
// regular, since |I - Y J| < 1.
// Real, for real F: the conjugate of the ball of radii kappa lies in B, so that conj(x*) is a root
// in B, and there is but one.
// Not real: some |Im m_j| > kappa_j. Neither: more digits.
// First in double: m a point of doubles after Newton's method, F(m) in double-double, J(B) in
// discs, every rounding bounded beforehand (src/certify/ball.h). What double does not decide goes
// to Arb's balls, of 128 bits, then 256, ... `most_bits`.
// F: n polynomials in n unknowns, and in numbers that are given by discs: solved in turn, the
// blocks of a triangular system are proved in turn, and the product of their balls holds exactly
// one root of the whole. Not supported: systems that are not square; radii that no double holds.
// The processor's rounding mode must be "to nearest", and denormal numbers must not be flushed to
// zero.
// Sources: [Krawczyk69], [Rump10], [BRT23], [Johansson17].
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "moivre/certify/certificate.h"
#include "moivre/numeric/complex.h"
#include "moivre/polynomial/system.h"

namespace moivre {

inline constexpr int kDoubleBits = 53;
inline constexpr int kFirstArbBits = 128;
/// A ball 2^-900 wide, about as small as a double says, holds a root whose J is as small: half for
/// the one, half for the other.
inline constexpr int kMostArbBits = 2048;

struct CertifyOptions {
  /// A root counts as found where |x* - x|_inf <= accuracy max(1, |x|_inf), x the given point.
  double accuracy = 1e-6;
  /// kDoubleBits: nothing but double. Twice as many follow where Newton's method converges
  /// quadratically: the proof lacks digits.
  int most_bits = kMostArbBits;
  /// Of a real F: go on with more digits until the root is proved real or not.
  bool decide_reality = true;
};

/// Whether digits beyond double's are built in; without them nothing is proved that double does not
/// prove.
bool proves_beyond_double();

/// F compiled for certificates: immutable, shared by all threads.
class CertifyProgram;

/// given: so many of the variables, the last ones, are given numbers and no unknowns. Throws
/// std::invalid_argument when F has not as many polynomials as unknowns, has no unknowns or more
/// than 2^32 - 1 registers.
std::shared_ptr<const CertifyProgram> make_certify_program(const System& f, std::size_t given = 0);

/// The memory for certificates of one program; one per thread, made and ended by that thread.
class Certifier {
 public:
  /// Throws std::invalid_argument when an option lies outside its range.
  explicit Certifier(std::shared_ptr<const CertifyProgram> program, CertifyOptions options = {});
  Certifier(Certifier&& other) noexcept;
  Certifier& operator=(Certifier&& other) noexcept;
  ~Certifier();

  std::size_t dimension() const noexcept;
  int most_bits() const noexcept;

  /// What can be proved of the root near x, n coordinates, wherever the given numbers lie in their
  /// discs (as many of each as the program has, else std::invalid_argument). Nothing is allocated
  /// where double is enough and `result` was filled before.
  void certify(std::span<const Complex> x, Certificate& result,
               std::span<const Enclosure> given = {});
  Certificate certify(std::span<const Complex> x, std::span<const Enclosure> given = {});

  /// Of the root near a point that double does not hold, x + finer[0] + finer[1] + ..., in `bits`
  /// of precision.
  Certificate certify_near(std::span<const Complex> x, std::span<const Point> finer, int bits);

  /// Proves the same root again with `bits` of precision, which makes its ball smaller. False if
  /// that failed; the certificate then does not change. Requires holds_root(), and the given
  /// numbers in the discs they were in or in smaller ones.
  bool sharpen(Certificate& certificate, int bits, std::span<const Enclosure> given = {});

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

/// A certificate for each point. threads: how many work on it; the result does not depend on them.
/// Once `stop` is true no further point is begun; those are undecided, with bits = 0. Throws as
/// Certifier does.
std::vector<Certificate> certify(const System& f, const std::vector<Point>& points,
                                 const CertifyOptions& options = {}, int threads = 1,
                                 const std::atomic<bool>& stop = std::atomic<bool>{false});

}  // namespace moivre
