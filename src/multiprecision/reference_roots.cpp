// SPDX-License-Identifier: MIT
// Up through the precisions: each level doubles the digits, the last one gives the bound.
#include "moivre/multiprecision/reference_roots.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <tuple>

#include "big_newton.h"
#include "moivre/expression/counted.h"
#include "moivre/numeric/invalid_input.h"
#include "moivre/numeric/threads.h"

namespace moivre {
namespace {

// What is worked with beyond the digits asked for, before more is taken: for the condition and for
// rounding.
constexpr int kGuardDigits = 35;
// The bound lies this many digits beyond the last one given, so that it is rounded rightly.
constexpr int kRoundingDigits = 8;
// Newton's method from a root known to a few digits needs about six iterations to fill the first
// level; at a multiple root it would go on for hundreds.
constexpr int kFirstIterations = 30;
constexpr int kLaterIterations = 8;

constexpr double kNoBound = std::numeric_limits<double>::infinity();

template <unsigned D>
double log10_of(const BigReal<D>& x) {
  return x > 0 ? static_cast<double>(log10(x)) : -kNoBound;
}

template <unsigned D>
BigReal<D> largest_size(const std::vector<BigComplex<D>>& v) {
  BigReal<D> largest(0);
  for (const BigComplex<D>& vi : v) largest = std::max(largest, norm(vi));
  return sqrt(largest);
}

/// max(1, |x|_inf).
template <unsigned D>
BigReal<D> scale_of(const std::vector<BigComplex<D>>& x) {
  return std::max(BigReal<D>(1), largest_size(x));
}

template <unsigned D>
std::string part_text(const BigReal<D>& part, const BigReal<D>& bound, int digits) {
  if (abs(part) <= bound) return "0";
  const double known = std::floor(log10_of<D>(abs(part) / bound));
  const int shown = std::clamp(static_cast<int>(std::min(known, 1e9)), 1, digits);
  return part.str(shown, std::ios_base::showpoint);
}

template <unsigned D>
DoubleDouble nearest_double_double(const BigReal<D>& x) {
  const auto hi = static_cast<double>(x);
  return {hi, static_cast<double>(BigReal<D>(x - hi))};
}

/// F in every precision, each made when it is first needed; one a thread.
class Climb {
 public:
  Climb(const System& f, const Tape& tape, const RowNorms& norms, int digits)
      : f_(f), tape_(tape), norms_(norms), digits_(digits) {}

  ReferenceRoot from(const ApproximateRoot& approximation) {
    given_ = &approximation;
    root_ = ReferenceRoot();
    level(given_in<kFirstLevel>(), kFirstIterations);
    return std::move(root_);
  }

 private:
  // Decimal digits of the levels: doubled each, and the last but one enough for kMostDigits.
  static constexpr unsigned kFirstLevel = 90;
  template <unsigned D>
  static constexpr unsigned next_level() {
    return D == 90 ? 180 : D == 180 ? 360 : D == 360 ? 720 : D == 720 ? 1100 : D == 1100 ? 2200 : 0;
  }

  template <unsigned D>
  BigNewton<D>& newton() {
    auto& made = std::get<std::unique_ptr<BigNewton<D>>>(levels_);
    if (!made) made = std::make_unique<BigNewton<D>>(f_, tape_, norms_);
    return *made;
  }

  template <unsigned D>
  std::vector<BigComplex<D>> given_in() const {
    std::vector<BigComplex<D>> x;
    for (const Complex& xi : given_->x) x.emplace_back(xi);
    for (const Point& part : given_->finer) {
      for (std::size_t i = 0; i < x.size(); ++i) x[i] += BigComplex<D>(part[i]);
    }
    return x;
  }

  /// Newton's method in D digits, until the result stands or the next level is to go on. Where it
  /// is lost in rounding errors, as beside roots of many near each other, the next level begins
  /// anew.
  template <unsigned D>
  void level(std::vector<BigComplex<D>> x, int iterations) {
    root_.working_digits = static_cast<int>(D);
    const bool may_finish = static_cast<int>(D) >= digits_ + kGuardDigits;
    std::vector<BigComplex<D>> dx(x.size());
    bool fills_level = false;
    for (int k = 0; k < iterations && (!fills_level || may_finish); ++k) {
      if (!newton<D>().correction(x, dx)) return;
      const double size = log10_of<D>(largest_size(dx) / scale_of(x));
      if (std::isnan(size)) return;
      root_.corrections_log10.push_back(size);
      if (may_finish && finish(x, dx, size)) return;
      for (std::size_t i = 0; i < x.size(); ++i) x[i] += dx[i];
      fills_level = size < -static_cast<double>(D) / 2;
    }
    if constexpr (next_level<D>() != 0) {
      constexpr unsigned kNext = next_level<D>();
      if (!fills_level) return level(given_in<kNext>(), kFirstIterations);
      std::vector<BigComplex<kNext>> finer;
      for (const BigComplex<D>& xi : x) finer.emplace_back(xi);
      level(std::move(finer), kLaterIterations);
    }
  }

  /// Fills the result where the bound covers the digits of every coordinate that differs from 0.
  template <unsigned D>
  bool finish(const std::vector<BigComplex<D>>& x, const std::vector<BigComplex<D>>& dx,
              double size) {
    if (size > -digits_) return false;
    const auto bound = newton<D>().bound(x, dx);
    if (!bound) return false;
    const BigReal<D> least = *bound * pow(BigReal<D>(10), digits_ + kRoundingDigits);
    for (const BigComplex<D>& xi : x) {
      const BigReal<D> xi_size = sqrt(norm(xi));
      if (xi_size > *bound && xi_size < least) return false;
    }
    root_.converged = true;
    root_.bound_log10 = log10_of<D>(*bound / scale_of(x));
    std::vector<BigComplex<D>> error = given_in<D>();
    for (std::size_t i = 0; i < x.size(); ++i) {
      root_.x.push_back({part_text(x[i].re, *bound, digits_), part_text(x[i].im, *bound, digits_)});
      root_.nearest.emplace_back(nearest_double_double(x[i].re), nearest_double_double(x[i].im));
      error[i] = error[i] - x[i];
    }
    root_.forward_error = static_cast<double>(BigReal<D>(largest_size(error) / scale_of(x)));
    return true;
  }

  template <unsigned... D>
  using Levels = std::tuple<std::unique_ptr<BigNewton<D>>...>;

  const System& f_;
  const Tape& tape_;
  const RowNorms& norms_;
  int digits_;
  Levels<90, 180, 360, 720, 1100, 2200> levels_;
  const ApproximateRoot* given_ = nullptr;
  ReferenceRoot root_;
};

/// MPFR keeps constants and free limbs for each thread; they go with the thread that asked for
/// them.
class MpfrCaches {
 public:
  MpfrCaches() = default;
  MpfrCaches(const MpfrCaches&) = delete;
  MpfrCaches& operator=(const MpfrCaches&) = delete;
  ~MpfrCaches() { mpfr_free_cache2(MPFR_FREE_LOCAL_CACHE); }
};

void require_usable(const System& f, const std::vector<ApproximateRoot>& approximations,
                    int digits) {
  require_unbroken(broken_rules(f));
  const std::size_t n = f.variables.size();
  if (digits < 1 || digits > kMostDigits) {
    throw InvalidInput("digits must lie between 1 and " + std::to_string(kMostDigits) + ", not " +
                       std::to_string(digits));
  }
  if (f.polynomials.size() != n) {
    throw InvalidInput("digits are for square systems; this one has " +
                       counted(f.polynomials.size(), "equation") + " in " + counted(n, "unknown"));
  }
  const auto require_point = [n](const Point& x) {
    if (!std::isfinite(max_norm(x))) {
      throw InvalidInput("an approximation has a coordinate that is not finite");
    }
    if (x.size() == n) return;
    throw InvalidInput("an approximation has " + counted(x.size(), "coordinate") + ", the system " +
                       counted(n, "unknown"));
  };
  for (const ApproximateRoot& approximation : approximations) {
    require_point(approximation.x);
    for (const Point& part : approximation.finer) require_point(part);
  }
}

}  // namespace

std::vector<ReferenceRoot> reference_roots_near(const System& f,
                                                const std::vector<ApproximateRoot>& approximations,
                                                int digits, int threads,
                                                const std::atomic<bool>& stop) {
  require_usable(f, approximations, digits);
  const Tape tape = make_tape(f);
  const RowNorms norms = row_norms(f);
  std::vector<ReferenceRoot> roots(approximations.size());
  const auto workers = std::clamp<std::size_t>(static_cast<std::size_t>(std::max(threads, 1)), 1,
                                               std::max<std::size_t>(roots.size(), 1));
  std::atomic<std::size_t> next = 0;
  on_threads(static_cast<int>(workers), [&] {
    const MpfrCaches caches;
    Climb climb(f, tape, norms, digits);
    for (std::size_t k = next++; k < roots.size() && !stop; k = next++) {
      roots[k] = climb.from(approximations[k]);
    }
  });
  return roots;
}

std::vector<ReferenceRoot> reference_roots(const System& f,
                                           const std::vector<Point>& approximations, int digits,
                                           int threads) {
  std::vector<ApproximateRoot> all;
  for (const Point& x : approximations) all.push_back({x});
  return reference_roots_near(f, all, digits, threads);
}

}  // namespace moivre
