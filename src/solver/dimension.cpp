// SPDX-License-Identifier: MIT
// Planes across the null space, Gauss-Newton on them when moved, and the way back to x.
#include "dimension.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "moivre/factorization/qr.h"
#include "moivre/numeric/random.h"

namespace moivre {

namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::VectorXcd;

constexpr double kStep = 0.1;
// The last step: sets that pass x at a few times this distance are told from sets through it.
constexpr double kLastStep = 5e-4;
// Of the extrapolation's last change: its error is less.
constexpr double kSureOfLimit = 10;
// A root further away than so many steps is not the neighbour that is looked for.
constexpr double kNeighbourhood = 20;
constexpr int kMaximumIterations = 60;
// An iteration count within which |F| halves wherever Gauss-Newton converges, to a multiple curve
// as well.
constexpr int kPatience = 6;
// |F| beside its terms: below the first a root without doubt; below the second one of a multiple
// set, where J is lost in its rounding before F is, provided that |F| falls by no more than kFall
// when the step is halved. An isolated root with |F| below the second has an order of 6 at least,
// and its |F| falls by 64.
constexpr double kOnTheSet = 1e-28;
constexpr double kNearTheSet = 1e-18;
// Below so many errors of the coefficients it is one of a system that the file may mean, provided
// the same.
constexpr double kErrors = 8;
constexpr double kFall = 16;
// Pivots of J, whose rows are relative to their terms, of directions in which a set may lie: x is
// known to 1e-3 at worst.
constexpr double kNullSpace = 1e-2;
// Where sets cross, a start near each is a matter of luck.
constexpr int kStarts = 8;
constexpr double kWander = 2;  // steps
// A set nearly parallel to one plane has its neighbour too far away: two of ten decide.
constexpr int kSlices = 10;
constexpr int kAgreeing = 2;
constexpr int kFurtherPlanes = 1000;  // their random numbers begin there

/// Where a set that a plane was moved along comes to as h -> 0, in units of z.
struct Limit {
  SetHere set = SetHere::none;
  double error = 0;
  double distance = 0;  ///< from x, beyond what x is known to; 0 where it may be x itself

  bool is_x() const { return distance <= error; }
};

/// The neighbourhood of one root, y = x + s z with s the natural sizes of the coordinates.
class Neighbourhood {
 public:
  Neighbourhood(const RefinerProgram& program, const Point& x, double tolerance, std::uint64_t seed,
                const std::atomic<bool>* stop);

  /// The limits of what a plane, moved, meets, up to the first that may be x.
  std::vector<Limit> met(int slice);
  /// x, in units of z, where it is known worst.
  double known_to() const;

 private:
  using Number = ComplexDoubleDouble;
  using FinePoint = std::vector<Number>;

  bool is_over() const { return stop_ != nullptr && stop_->load(std::memory_order_relaxed); }
  Index dimension() const { return static_cast<Index>(x_.size()); }
  Index equations() const { return static_cast<Index>(program_.tape.equations); }
  void evaluate_at(const FinePoint& z);
  VectorXcd rounded(const FinePoint& z) const;
  VectorXcd random_vector(Index size, int number) const;
  FinePoint start_on(const VectorXcd& plane, int number) const;
  std::optional<Limit> limit(MatrixXcd planes, int slice, FinePoint z);
  void cut_to_a_curve(MatrixXcd& planes, int slice, FinePoint& z);
  bool is_determined(Index planes) const;
  std::optional<double> settle(const MatrixXcd& planes, double step, FinePoint& z);
  std::optional<Limit> extrapolated(const std::vector<VectorXcd>& halvings) const;

  const RefinerProgram& program_;
  const Point& x_;
  double known_to_;  ///< x, absolute
  std::uint64_t seed_;
  const std::atomic<bool>* stop_;
  std::vector<double> scale_;
  MatrixXcd null_space_;
  std::vector<double> size_y_, size_registers_, size_;
  std::vector<Complex> y_, registers_, ignored_, jacobian_;
  FinePoint fine_y_, fine_registers_, fine_value_;
  std::vector<double> error_;  ///< of F's terms, where coefficients were rounded
  double zero_ = 0;            ///< |F| relative to its terms, at a root
  VectorXcd value_;            ///< F relative to its terms, and as many planes as N has columns
  MatrixXcd j_;                ///< of value_ with respect to z
};

Neighbourhood::Neighbourhood(const RefinerProgram& program, const Point& x, double tolerance,
                             std::uint64_t seed, const std::atomic<bool>* stop)
    : program_(program),
      x_(x),
      known_to_(tolerance * std::max(1.0, max_norm(x))),
      seed_(seed),
      stop_(stop),
      size_y_(x.size()),
      size_registers_(program.tape.register_count()),
      size_(program.tape.equations),
      y_(x.size()),
      registers_(program.tape.register_count()),
      ignored_(program.tape.equations),
      jacobian_(program.tape.jacobian.size()),
      fine_y_(x.size()),
      fine_registers_(program.tape.register_count()),
      fine_value_(program.tape.equations),
      error_(program.tape.equations),
      value_(static_cast<Index>(program.tape.equations) + dimension()),
      j_(MatrixXcd::Zero(value_.size(), dimension())) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    scale_.push_back(std::max(std::abs(x[i]), program.unit[i]));
  }
  evaluate_at(FinePoint(x.size()));
  const PivotedQr<Complex> rows(j_.topRows(equations()).adjoint());
  const Index rank = (rows.pivots().array() > kNullSpace).count();
  const Index width = rank < dimension() ? dimension() - rank : dimension();
  null_space_ = rows.last_columns_of_Q(width);
}

// F in double-double, J in double, each row relative to the sizes of its terms. Coordinates below
// their step count as of that size: where one vanishes on the set, the terms would vanish with the
// values.
void Neighbourhood::evaluate_at(const FinePoint& z) {
  const Tape& tape = program_.tape;
  for (std::size_t i = 0; i < x_.size(); ++i) {
    fine_y_[i] = Number(x_[i]) + product(DoubleDouble(scale_[i]), z[i]);
    y_[i] = to_complex(fine_y_[i]);
    size_y_[i] = std::max(std::abs(y_[i]), kStep * scale_[i]);
  }
  evaluate<double, double>(tape, program_.size, size_y_, size_registers_, size_);
  if (!program_.error.empty()) {
    evaluate<double, double>(tape, program_.error, size_y_, size_registers_, error_);
  }
  evaluate<Number, Number>(tape, program_.exact, fine_y_, fine_registers_, fine_value_);
  evaluate<Complex, Complex>(tape, program_.c, y_, registers_, ignored_, jacobian_);
  for (double& size : size_) size = size > 0 ? size : 1;
  zero_ = kNearTheSet;
  for (std::size_t i = 0; i < fine_value_.size(); ++i) {
    const auto row = static_cast<Index>(i);
    value_[row] = to_complex(fine_value_[i]) / size_[i];
    zero_ = std::max(zero_, kErrors * error_[i] / size_[i]);
  }
  for (std::size_t k = 0; k < jacobian_.size(); ++k) {
    const Tape::Entry& entry = tape.jacobian[k];
    j_(entry.row, entry.column) = jacobian_[k] * (scale_[entry.column] / size_[entry.row]);
  }
}

VectorXcd Neighbourhood::rounded(const FinePoint& z) const {
  VectorXcd result(dimension());
  std::transform(z.begin(), z.end(), result.data(),
                 [](const Number& zi) { return to_complex(zi); });
  return result;
}

VectorXcd Neighbourhood::random_vector(Index size, int number) const {
  VectorXcd v(size);
  for (Index i = 0; i < size; ++i) {
    const auto index = static_cast<std::uint64_t>(number * size + i);
    v[i] = random_unit(seed_, RandomStream::slice, 2 * index) *
           random_phase(seed_, RandomStream::slice, 2 * index + 1);
  }
  return v;
}

// N c with plane N c = step, the rest of c at random; least for the first start.
Neighbourhood::FinePoint Neighbourhood::start_on(const VectorXcd& plane, int number) const {
  VectorXcd c = VectorXcd::Zero(plane.size());
  if (number % kStarts > 0) c = kWander * kStep * random_vector(plane.size(), kSlices + number);
  c += plane * (kStep - plane.dot(c));
  const VectorXcd z = null_space_ * c;
  return FinePoint(z.begin(), z.end());
}

std::vector<Limit> Neighbourhood::met(int slice) {
  const VectorXcd plane = random_vector(null_space_.cols(), slice).normalized();
  std::vector<Limit> limits;
  for (int start = 0; start < kStarts && !is_over(); ++start) {
    const auto there = limit(plane, slice, start_on(plane, slice * kStarts + start));
    if (!there) continue;
    limits.push_back(*there);
    if (there->is_x()) break;
  }
  return limits;
}

double Neighbourhood::known_to() const {
  return known_to_ / *std::min_element(scale_.begin(), scale_.end());
}

/// Whether F and so many planes leave nothing free where they were settled last.
bool Neighbourhood::is_determined(Index planes) const {
  const PivotedQr<Complex> rows(j_.topRows(equations() + planes));
  return (rows.pivots().array() > kNullSpace).count() == dimension();
}

// Where the set is a surface the plane leaves z free. Planes through x are added as long as they
// meet the set.
void Neighbourhood::cut_to_a_curve(MatrixXcd& planes, int slice, FinePoint& z) {
  while (planes.cols() < null_space_.cols() && !is_determined(planes.cols())) {
    MatrixXcd more(planes.rows(), planes.cols() + 1);
    more << planes,
        random_vector(planes.rows(), kFurtherPlanes + slice * static_cast<int>(more.cols()))
            .normalized();
    FinePoint there = z;
    if (!settle(more, kStep, there)) return;
    planes = std::move(more);
    z = std::move(there);
  }
}

std::optional<Limit> Neighbourhood::limit(MatrixXcd planes, int slice, FinePoint z) {
  if (!settle(planes, kStep, z)) return {};
  cut_to_a_curve(planes, slice, z);
  std::optional<double> before = settle(planes, kStep, z);
  if (!before) return {};
  bool is_sharp = *before <= kOnTheSet;
  std::vector<VectorXcd> halvings{rounded(z)};
  for (double step = kStep / 2; step > kLastStep; step /= 2) {
    for (Number& zi : z) zi = product(DoubleDouble(0.5), zi);
    const std::optional<double> now = settle(planes, step, z);
    if (!now || (*now > kOnTheSet && *now * kFall < *before)) return {};
    is_sharp = is_sharp && *now <= kOnTheSet;
    before = now;
    halvings.push_back(rounded(z));
  }
  auto limit = extrapolated(halvings);
  if (limit) limit->set = is_sharp ? SetHere::sharp : SetHere::blurred;
  return limit;
}

// Neville's extrapolation to h = 0 of z at h, h / 2, h / 4, ...; its last two values tell the
// error. What is no power series, as where |F| only passes for 0, has no limit that is better known
// than the last step.
std::optional<Limit> Neighbourhood::extrapolated(const std::vector<VectorXcd>& halvings) const {
  std::vector<VectorXcd> row;
  VectorXcd before;
  for (const VectorXcd& z : halvings) {
    if (!row.empty()) before = row.back();
    std::vector<VectorXcd> next{z};
    double power = 1;
    for (const VectorXcd& above : row) {
      power *= 2;
      next.push_back(next.back() + (next.back() - above) / (power - 1));
    }
    row = std::move(next);
  }
  const VectorXcd& limit = row.back();
  Limit told;
  told.error = kSureOfLimit * (limit - before).lpNorm<Eigen::Infinity>();
  if (told.error > kLastStep) return {};
  for (Index i = 0; i < limit.size(); ++i) {
    const double known = known_to_ / scale_[static_cast<std::size_t>(i)];
    told.distance = std::max(told.distance, std::abs(limit[i]) - known);
  }
  return told;
}

// Gauss-Newton from z on the first plane N^H z = step and, of the others, N^H z = 0. |F| where it
// ends; nullopt where that is no root nearby.
std::optional<double> Neighbourhood::settle(const MatrixXcd& planes, double step, FinePoint& z) {
  const Index m = equations();
  const Index p = planes.cols();
  j_.middleRows(m, p) = (null_space_ * planes).adjoint();
  double best = std::numeric_limits<double>::infinity();
  double aim = best;
  bool is_root = false;
  int waited = 0;
  for (int k = 0; k < kMaximumIterations && waited < kPatience; ++k) {
    if (is_over()) return {};
    evaluate_at(z);
    const VectorXcd here = rounded(z);
    if (!here.allFinite() || here.lpNorm<Eigen::Infinity>() > kNeighbourhood * step) return {};
    value_.segment(m, p) = j_.middleRows(m, p) * here;
    value_[m] -= step;
    const double size = value_.head(m).lpNorm<Eigen::Infinity>();
    if (k > 0 && size < best) {
      best = size;
      is_root = size <= zero_;
    }
    if (k > 0 && size < kOnTheSet) break;
    waited = size < aim / 2 ? 0 : waited + 1;
    aim = std::min(aim, size);
    const VectorXcd dz =
        shortest_solution(MatrixXcd(j_.topRows(m + p)), VectorXcd(-value_.head(m + p)));
    for (Index i = 0; i < dz.size(); ++i) z[static_cast<std::size_t>(i)] += Number(dz[i]);
  }
  return is_root ? std::optional(best) : std::nullopt;
}

}  // namespace

SetHere set_through(const RefinerProgram& program, const Point& x, double tolerance,
                    std::uint64_t seed, const std::atomic<bool>* stop) {
  if (x.size() < 2) return SetHere::none;
  Neighbourhood neighbourhood(program, x, tolerance, seed, stop);
  std::vector<Limit> through;
  double beside = std::numeric_limits<double>::infinity();
  int sure = 0;
  for (int slice = 0; slice < kSlices && sure < kAgreeing; ++slice) {
    for (const Limit& limit : neighbourhood.met(slice)) {
      if (!limit.is_x()) {
        beside = std::min(beside, limit.distance);
        continue;
      }
      through.push_back(limit);
      if (limit.error <= neighbourhood.known_to()) ++sure;
    }
    const auto found = static_cast<int>(through.size());
    if (found + (kSlices - 1 - slice) < kAgreeing) return SetHere::none;
  }
  // A set that is known to pass beside x explains limits that are known no better than that.
  std::erase_if(through, [&](const Limit& limit) { return limit.error >= beside; });
  if (through.size() < kAgreeing) return SetHere::none;
  return std::min_element(through.begin(), through.end(),
                          [](const Limit& a, const Limit& b) { return a.set < b.set; })
      ->set;
}

}  // namespace moivre
