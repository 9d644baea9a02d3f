// SPDX-License-Identifier: MIT
// Krawczyk's operator in Arb's balls: the rounding is Arb's care, the points and radii are chosen
// here.
#include "arb_stage.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

#include "arb_ball.h"
#include "arb_numbers.h"
#include "moivre/certify/certifier.h"
#include "moivre/numeric/integer.h"

namespace moivre {
namespace {

// The evaluations have so many bits more than the points.
constexpr slong kGuardBits = 32;
// Newton's method may gain but a bit an iteration near a cluster, until it converges quadratically
// or rounding ends it.
constexpr slong kIterationsPerBit = 1;
// A correction of fewer than 0.6 bits of the precision leaves, squared, an error below the
// rounding.
constexpr double kSettledShare = 0.6;
// Where corrections have not become smaller so many times in a row, this precision has no more to
// give.
constexpr int kMostStalls = 4;
// Where J is nearly singular a step goes too far, and the next ones bring it back; farther than
// allowed it has left after more of them.
constexpr int kMostOutside = 4;
// Towards a root of multiplicity m corrections fall to a share of 1 - 1/m, at least a half;
// quadratically, to less and less.
constexpr double kQuadraticShare = 0.1;
// Where they fall to one share twice, to within this, the sum of all that follow is known. So many
// times the difference of the two are left of it, and more than rounding makes of their ratio: of
// two roots near each other that on one's own side stays the nearer one.
constexpr double kSteadyShare = 0.02;
constexpr double kTimesLeft = 8;
constexpr double kLeastLeft = 0x1p-40;
constexpr double kLeastSteadyShare = 0.4;
constexpr double kMostSteadyShare = 0.97;

/// Radii to begin with, b bits: 2^(error_bits b) times the error, 2^(point_bits b) of the
/// coordinates, each taken for no smaller than a share of the largest. The order is that of double.
struct Start {
  double error_bits, point_bits, least_weight;
};
constexpr Start kStarts[] = {{0.125, -0.75, 0x1p-10}, {0.125, -0.75, 0}, {0.02, -1, 0}};
constexpr int kAttempts = 6;
// The image shrinks by |I - Y J| each time that it is taken for the ball.
constexpr int kTightenings = 2;
// The size of an unknown is at least this share of the largest one: less is no scale for a
// correction.
constexpr double kLeastWeight = 0x1p-40;
constexpr double kHopeless = 0x1p30;
constexpr double kHuge = 0x1p900;
// mag_get_d ends there, and a radius must be positive.
constexpr double kLeastRadius = 0x1p-900;

constexpr slong kBitsOfDouble = 53;

using moivre::add_exactly;
using moivre::set;

void set(arb_t result, const Rational& value, slong bits) {
  fmpz_t over, under;
  fmpz_init(over);
  fmpz_init(under);
  set(over, numerator(value));
  set(under, denominator(value));
  arb_fmpz_div_fmpz(result, over, under, bits);
  fmpz_clear(over);
  fmpz_clear(under);
}

ArbBall to_arb(const Coefficient& c, slong bits) {
  ArbBall result;
  set(acb_realref(result.get()), c.re, bits);
  set(acb_imagref(result.get()), c.im, bits);
  result.set_bits(bits);
  return result;
}

void add_exactly(ArbBall& sum, const Complex& value) {
  add_exactly(acb_realref(sum.get()), value.real());
  add_exactly(acb_imagref(sum.get()), value.imag());
}

double modulus_of(acb_srcptr z) {
  mag_t size;
  mag_init(size);
  acb_get_mag(size, z);
  const double result = mag_get_d(size);
  mag_clear(size);
  return result;
}

/// |a - b|, to the precision of a bound.
double distance(acb_srcptr a, acb_srcptr b) {
  acb_t difference;
  acb_init(difference);
  acb_sub(difference, a, b, kBitsOfDouble);
  const double result = modulus_of(difference);
  acb_clear(difference);
  return result;
}

/// A matrix that owns its entries.
class ArbMatrix {
 public:
  ArbMatrix(std::size_t rows, std::size_t columns) {
    acb_mat_init(value_, static_cast<slong>(rows), static_cast<slong>(columns));
  }
  ArbMatrix(const ArbMatrix&) = delete;
  ArbMatrix& operator=(const ArbMatrix&) = delete;
  ~ArbMatrix() { acb_mat_clear(value_); }

  acb_mat_struct* get() { return value_; }
  acb_ptr entry(std::size_t i, std::size_t j) {
    return acb_mat_entry(value_, static_cast<slong>(i), static_cast<slong>(j));
  }

 private:
  acb_mat_t value_;
};

}  // namespace

class ArbStage::Work {
 public:
  explicit Work(const CertifyProgram& program);

  ArbOutcome prove(std::span<const Complex> midpoint, std::span<const Point> finer,
                   std::span<const Enclosure> given, int bits, double farthest,
                   Certificate& result);

 private:
  void take(std::span<const Enclosure> given);
  ArbOutcome approach(double farthest);
  double largest_coordinate() const;
  void split_midpoint(Certificate& result);
  bool find_radii(Certificate& result);
  void image(const std::vector<double>& rho, std::vector<double>& kappa);
  void tighten(std::vector<double>& kappa);
  std::vector<double> apply(const std::vector<double>& reach);
  void evaluate_at(std::span<const ArbBall> unknowns);
  bool find_step();
  void go_on(double times);
  const std::vector<ArbBall>& coefficients();

  const CertifyProgram& program_;
  std::size_t n_;
  slong bits_ = 0;
  std::map<slong, std::vector<ArbBall>> coefficients_;  // by precision
  std::vector<ArbBall> start_, m_, ball_;
  std::vector<ArbBall> x_, registers_, values_,
      jacobian_;  // of the tape; x_: unknowns, then given numbers
  ArbMatrix j_, y_, g_;
  ArbMatrix f_, step_;         // F and its radii; J^-1 or Y times these
  std::vector<double> fixed_;  // |Y F(m)|
};

ArbStage::Work::Work(const CertifyProgram& program)
    : program_(program),
      n_(program.dimension()),
      m_(n_),
      ball_(n_),
      x_(program.tape.variables),
      registers_(program.tape.register_count()),
      values_(n_),
      jacobian_(program.tape.jacobian.size()),
      j_(n_, n_),
      y_(n_, n_),
      g_(n_, n_),
      f_(n_, 2),
      step_(n_, 2),
      fixed_(n_) {
  thread_local const FlintCaches caches;
}

const std::vector<ArbBall>& ArbStage::Work::coefficients() {
  const slong bits = bits_ + kGuardBits;
  auto [position, is_new] = coefficients_.try_emplace(bits);
  if (is_new) {
    position->second = round_coefficients<ArbBall>(
        program_.tape, program_.system, [&](const Coefficient& c) { return to_arb(c, bits); });
  }
  return position->second;
}

/// Discs as Arb's rectangles around them.
void ArbStage::Work::take(std::span<const Enclosure> given) {
  for (std::size_t k = 0; k < given.size(); ++k) {
    ArbBall& z = x_[n_ + k];
    acb_zero(z.get());
    add_exactly(z, given[k].middle);
    for (const Complex& part : given[k].finer) add_exactly(z, part);
    const ArbSize error(given[k].error);
    arb_add_error_mag(acb_realref(z.get()), error.get());
    arb_add_error_mag(acb_imagref(z.get()), error.get());
    z.set_bits(bits_ + kGuardBits);
  }
}

ArbOutcome ArbStage::Work::prove(std::span<const Complex> midpoint, std::span<const Point> finer,
                                 std::span<const Enclosure> given, int bits, double farthest,
                                 Certificate& result) {
  bits_ = bits;
  for (std::size_t j = 0; j < n_; ++j) {
    acb_zero(m_[j].get());
    add_exactly(m_[j], midpoint[j]);
    for (const Point& part : finer) add_exactly(m_[j], part[j]);
    m_[j].set_bits(bits_ + kGuardBits);
  }
  take(given);
  start_ = m_;
  const ArbOutcome outcome = approach(farthest);
  if (outcome == ArbOutcome::left) return outcome;
  split_midpoint(result);
  if (!find_radii(result)) return outcome;
  result.bits = bits;
  return ArbOutcome::proved;
}

/// values_ and jacobian_; F and J as matrices.
void ArbStage::Work::evaluate_at(std::span<const ArbBall> unknowns) {
  std::copy(unknowns.begin(), unknowns.end(), x_.begin());
  evaluate<ArbBall, ArbBall>(program_.tape, coefficients(), x_, registers_, values_, jacobian_);
  acb_mat_zero(j_.get());
  for (std::size_t i = 0; i < n_; ++i) acb_set(f_.entry(i, 0), values_[i].get());
  for (std::size_t k = 0; k < jacobian_.size(); ++k) {
    const Tape::Entry& entry = program_.tape.jacobian[k];
    acb_set(j_.entry(entry.row, entry.column), jacobian_[k].get());
  }
}

double ArbStage::Work::largest_coordinate() const {
  double largest = 0;
  for (const ArbBall& mj : m_) largest = std::max(largest, modulus_of(mj.get()));
  return largest;
}

/// step_: J^-1 F, and J^-1 of the radii of F, an estimate of what its rounding errors make of that.
/// False where J is singular.
bool ArbStage::Work::find_step() {
  for (std::size_t i = 0; i < n_; ++i) {
    acb_srcptr value = values_[i].get();
    arb_get_rad_arb(acb_realref(f_.entry(i, 1)), acb_realref(value));
    arb_get_rad_arb(acb_imagref(f_.entry(i, 1)), acb_imagref(value));
  }
  acb_mat_zero(step_.get());  // approximate functions leave radii as they are
  return acb_mat_approx_solve(step_.get(), j_.get(), f_.get(), bits_ + kGuardBits) != 0;
}

/// The last step once more, so many times.
void ArbStage::Work::go_on(double times) {
  arb_t factor;
  arb_init(factor);
  arb_set_d(factor, times);
  for (std::size_t j = 0; j < n_; ++j) {
    acb_mul_arb(step_.entry(j, 0), step_.entry(j, 0), factor, bits_ + kGuardBits);
    acb_sub(m_[j].get(), m_[j].get(), step_.entry(j, 0), bits_ + kGuardBits);
    acb_get_mid(m_[j].get(), m_[j].get());
  }
  arb_clear(factor);
}

/// Newton's method until its correction is small enough, or no better; the test is left to say what
/// the point is worth. Never `proved`. Where corrections fall by one ratio r it goes on at once by
/// nearly what they add up to, r / (1 - r) of the last [DeckerKelley82]; back, where that gains
/// nothing: simple roots near each other are apart there.
ArbOutcome ArbStage::Work::approach(double farthest) {
  const double settled = std::exp2(-kSettledShare * static_cast<double>(bits_));
  double last = HUGE_VAL;
  double last_ratio = 1;
  int stalls = 0;
  int outside = 0;
  std::vector<ArbBall> before;  // going on; empty where Newton's method alone has come here
  double least_gain = 1;        // of having gone on: what one more correction would have made
  bool may_go_on = true;
  const auto go_back = [&] {
    m_ = std::exchange(before, {});
    may_go_on = false;
    last_ratio = 1;
  };
  ArbOutcome outcome = ArbOutcome::not_proved;
  for (slong k = 0; k < kIterationsPerBit * bits_; ++k) {
    evaluate_at(m_);
    const bool has_step = find_step();
    if (!has_step && before.empty()) return ArbOutcome::not_proved;
    if (!has_step) {
      go_back();
      continue;
    }
    const double least = std::max(kLeastWeight * largest_coordinate(), kLeastRadius);
    double share = 0;
    double noise = 0;  // about what rounding makes of it
    double moved = 0;
    for (std::size_t j = 0; j < n_; ++j) {
      acb_ptr mj = m_[j].get();
      acb_sub(mj, mj, step_.entry(j, 0), bits_ + kGuardBits);
      acb_get_mid(mj, mj);
      const double step = modulus_of(step_.entry(j, 0));
      const double size = modulus_of(mj);
      if (!std::isfinite(step) || !std::isfinite(size)) {
        share = HUGE_VAL;
        break;
      }
      share = std::max(share, step / std::max(size, least));
      noise = std::max(noise, modulus_of(step_.entry(j, 1)) / std::max(size, least));
      moved = std::max(moved, distance(mj, start_[j].get()));
    }
    if (!before.empty() && !(share < least_gain * last)) {
      go_back();
      continue;
    }
    if (!std::isfinite(share)) return ArbOutcome::not_proved;
    // A step that rounding can make tells nothing, nor would the next.
    const bool tells = share > noise;
    outside = moved > farthest ? outside + 1 : 0;
    if (!tells && outside > 0) return ArbOutcome::not_proved;
    if (outside > kMostOutside) return ArbOutcome::left;
    if (!tells) break;
    before.clear();
    const double ratio = share / last;
    const bool is_quadratic = last_ratio < kQuadraticShare && ratio < last_ratio;
    if (is_quadratic) outcome = ArbOutcome::converged;
    if (share <= settled) break;
    stalls = share < last ? 0 : stalls + 1;
    const bool is_steady = may_go_on && std::abs(ratio - last_ratio) < kSteadyShare &&
                           kLeastSteadyShare < ratio && ratio < kMostSteadyShare;
    const double left = std::max(kLeastLeft, kTimesLeft * std::abs(ratio - last_ratio));
    last = share;
    last_ratio = ratio;
    if (is_steady) {
      before = m_;
      least_gain = ratio;
      go_on((1 - left) * ratio / (1 - ratio));
      last_ratio = 1;
    }
    if (stalls > kMostStalls) break;
  }
  if (outside > 0) return ArbOutcome::left;
  return outcome;
}

/// m_ <- a sum of doubles near it, exactly what `result` then holds.
void ArbStage::Work::split_midpoint(Certificate& result) {
  const auto parts = static_cast<std::size_t>((bits_ + kBitsOfDouble - 1) / kBitsOfDouble);
  result.midpoint.assign(n_, Complex(0));
  std::vector<Point> finer(parts, Point(n_));
  for (std::size_t j = 0; j < n_; ++j) {
    ArbBall rest = m_[j];
    acb_zero(m_[j].get());
    for (std::size_t k = 0; k <= parts; ++k) {
      const Complex part(take_double(acb_realref(rest.get())),
                         take_double(acb_imagref(rest.get())));
      (k == 0 ? result.midpoint[j] : finer[k - 1][j]) = part;
      add_exactly(acb_realref(m_[j].get()), part.real());
      add_exactly(acb_imagref(m_[j].get()), part.imag());
    }
  }
  while (!finer.empty() && finer.back() == Point(n_)) finer.pop_back();
  result.finer.assign(finer.begin(), finer.end());
}

bool ArbStage::Work::find_radii(Certificate& result) {
  const slong bits = bits_ + kGuardBits;
  evaluate_at(m_);
  if (!acb_mat_approx_inv(y_.get(), j_.get(), bits)) return false;
  acb_mat_mul(step_.get(), y_.get(), f_.get(), bits);
  for (std::size_t j = 0; j < n_; ++j) {
    ArbSize size;
    acb_get_mag(size.get(), step_.entry(j, 0));
    fixed_[j] = size.upper();
  }
  const auto b = static_cast<double>(bits_);
  const double largest = largest_coordinate();
  std::vector<double> rho(n_);
  std::vector<double> kappa(n_);
  for (const Start& start : kStarts) {
    for (std::size_t j = 0; j < n_; ++j) {
      const double size = std::max(modulus_of(m_[j].get()), start.least_weight * largest);
      rho[j] = std::exp2(start.error_bits * b) * fixed_[j] +
               std::exp2(start.point_bits * b) * size + kLeastRadius;
    }
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      image(rho, kappa);
      bool inside = true;
      bool hopeless = false;
      for (std::size_t j = 0; j < n_; ++j) {
        if (kappa[j] < rho[j]) continue;
        inside = false;
        const double most = attempt == 0 ? kHuge : kHopeless * rho[j];
        hopeless = hopeless || !(kappa[j] < most);
        rho[j] = 2 * kappa[j];
      }
      if (inside) {
        for (int k = 0; k < kTightenings; ++k) tighten(kappa);
        result.sizes.assign(rho, kappa);
        return result.sizes.are_apart();
      }
      if (hopeless) break;
    }
  }
  return false;
}

/// kappa of rho; g_ <- I - Y J(B). B's discs are enclosed in squares.
void ArbStage::Work::image(const std::vector<double>& rho, std::vector<double>& kappa) {
  const slong bits = bits_ + kGuardBits;
  ball_ = m_;
  for (std::size_t j = 0; j < n_; ++j) {
    const ArbSize radius(rho[j]);
    acb_add_error_mag(ball_[j].get(), radius.get());
  }
  evaluate_at(ball_);
  acb_mat_mul(g_.get(), y_.get(), j_.get(), bits);
  for (std::size_t j = 0; j < n_; ++j) acb_sub_si(g_.entry(j, j), g_.entry(j, j), 1, bits);
  kappa = apply(rho);
}

/// The root lies within kappa of m: so it lies within the image of that, too.
void ArbStage::Work::tighten(std::vector<double>& kappa) {
  const std::vector<double> again = apply(kappa);
  for (std::size_t j = 0; j < n_; ++j) kappa[j] = std::min(kappa[j], again[j]);
}

/// |Y F(m)| + |I - Y J(B)| reach, rounded up.
std::vector<double> ArbStage::Work::apply(const std::vector<double>& reach) {
  std::vector<double> result(n_);
  for (std::size_t j = 0; j < n_; ++j) {
    ArbSize sum(fixed_[j]);
    for (std::size_t k = 0; k < n_; ++k) {
      ArbSize size;
      acb_get_mag(size.get(), g_.entry(j, k));
      const ArbSize part(reach[k]);
      mag_addmul(sum.get(), size.get(), part.get());
    }
    result[j] = sum.upper();
  }
  return result;
}

bool proves_beyond_double() { return true; }

ArbStage::ArbStage(const CertifyProgram& program) : work_(std::make_unique<Work>(program)) {}
ArbStage::~ArbStage() = default;

ArbOutcome ArbStage::prove(std::span<const Complex> midpoint, std::span<const Point> finer,
                           std::span<const Enclosure> given, int bits, double farthest,
                           Certificate& result) {
  return work_->prove(midpoint, finer, given, bits, farthest, result);
}

}  // namespace moivre
