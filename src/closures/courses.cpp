// SPDX-License-Identifier: MIT
// Values at poses, made to go on, and the extremes of polynomials between them.
#include "courses.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <numbers>

#include "moivre/kinematics/linear.h"
#include "moivre/mechanism/pose.h"

namespace moivre {
namespace {

using Eigen::VectorXd;

constexpr double kTurn = 2 * std::numbers::pi;
// Poses beside an event: six parts of a way of a few tenths of a radian leave 1e-8 of it to a polynomial of degree six.
constexpr int kParts = 6;
// Radians, or of the mechanism's length: further from every pose than this a polynomial is not believed.
constexpr double kFar = 1e-2;
// The step of central differences along the motion, in radians or lengths: their error is its square.
constexpr double kDifference = 1e-4;

/// A pose of the branch.
struct Station {
  double time = 0;
  VectorXd q;
  const BranchSample* sample = nullptr;
};

/// Poses `first` to `last` of a path: two samples, or an event and the sample beside it with poses between.
struct Piece {
  std::size_t first = 0;
  std::size_t last = 0;
  bool is_at_event = false;
};

struct Path {
  std::vector<Station> stations;  ///< by time
  std::vector<Piece> pieces;
};

/// A pose that Newton's method puts right; nullopt where it leads further away than `reach`.
std::optional<VectorXd> put_right(const Phi& phi, const VectorXd& guess, double time,
                                  double reach) {
  constexpr int kSteps = 8;
  constexpr double kConverged = 1e-11;
  VectorXd q = guess;
  for (int k = 0; k < kSteps; ++k) {
    const VectorXd step = Factorisation(phi.jacobian(q, time)).solve(-phi.value(q, time));
    q += step;
    if (!((q - guess).norm() <= reach)) return std::nullopt;
    if (step.norm() <= kConverged * std::max(1.0, q.norm())) return q;
  }
  return std::nullopt;
}

/// Poses between the event and the sample, from the event on; none where one of them is not found.
std::vector<Station> beside_event(const Phi& phi, const Station& event, const Station& sample) {
  std::vector<Station> all;
  for (int k = 1; k < kParts; ++k) {
    const double u = static_cast<double>(k) / kParts;
    const double time = event.time + (sample.time - event.time) * u * u;
    const VectorXd guess = event.q + u * (sample.q - event.q);
    const auto q = put_right(phi, guess, time, (sample.q - event.q).norm());
    if (!q) return {};
    all.push_back({time, *q, nullptr});
  }
  return all;
}

void append(Path& path, const std::vector<Station>& stations, bool is_at_event) {
  if (path.stations.empty()) {
    path.stations = stations;
  } else {
    path.stations.insert(path.stations.end(), stations.begin() + 1, stations.end());
  }
  const std::size_t last = path.stations.size() - 1;
  path.pieces.push_back({last + 1 - stations.size(), last, is_at_event});
}

Path path_of(const Phi& phi, const MotionBranch& branch) {
  const Station begin{branch.begins, branch.begin_pose, nullptr};
  const Station end{branch.ends, branch.end_pose, nullptr};
  Path path;
  if (branch.samples.empty()) return {{begin, end}, {}};
  std::vector<Station> samples;
  for (const BranchSample& sample : branch.samples) {
    samples.push_back({sample.time, sample.q, &sample});
  }
  path.stations = {samples.front()};
  if (branch.begin_event && branch.begins < samples.front().time) {
    std::vector<Station> way = beside_event(phi, begin, samples.front());
    way.insert(way.begin(), begin);
    way.push_back(samples.front());
    path.stations.clear();
    append(path, way, way.size() == kParts + 1);
  }
  for (std::size_t k = 1; k < samples.size(); ++k) {
    append(path, {samples[k - 1], samples[k]}, false);
  }
  if (branch.end_event && branch.ends > samples.back().time) {
    std::vector<Station> way = beside_event(phi, end, samples.back());
    way.push_back(samples.back());
    std::reverse(way.begin(), way.end());
    way.push_back(end);
    append(path, way, way.size() == kParts + 1);
  }
  return path;
}

double difference(const Quantity& quantity, double a, double b) {
  const bool is_cut = !quantity.goes_on && quantity.kind == CoordinateKind::angle;
  return is_cut ? std::remainder(a - b, kTurn) : a - b;
}

std::vector<double> values_along(const Path& path, const Quantity& quantity) {
  std::vector<double> values;
  for (const Station& station : path.stations) {
    const double value = quantity.value(station.q);
    values.push_back(values.empty() ? value
                                    : values.back() + difference(quantity, value, values.back()));
  }
  return values;
}

struct Rates {
  double velocity = 0;
  double acceleration = 0;
};

/// By central differences along q + t q' + t^2 q'' / 2; nullopt where the sample has no velocity.
std::optional<Rates> rates_at(const Station& station, const Quantity& quantity) {
  if (station.sample == nullptr || !station.sample->is_determined) return std::nullopt;
  const VectorXd& velocity = station.sample->velocity;
  const VectorXd& acceleration = station.sample->acceleration;
  if (velocity.size() == 0 || !velocity.allFinite() || !acceleration.allFinite()) {
    return std::nullopt;
  }
  const double speed = std::max(velocity.norm(), std::sqrt(acceleration.norm()));
  if (!(speed > 0)) return Rates{};
  const double dt = kDifference / speed;
  const double here = quantity.value(station.q);
  const auto moved = [&](double t) {
    const VectorXd q = station.q + t * velocity + t * t / 2 * acceleration;
    return difference(quantity, quantity.value(q), here);
  };
  const double later = moved(dt);
  const double earlier = moved(-dt);
  return Rates{(later - earlier) / (2 * dt), (later + earlier) / (dt * dt)};
}

/// A smooth curve over [0, 1].
using Curve = std::function<double(double)>;

/// From value 0 to `rise`, h seconds later: of degree five.
Curve hermite(double rise, const Rates& a, const Rates& b, double h) {
  const double v0 = h * a.velocity;
  const double v1 = h * b.velocity;
  const double a0 = h * h * a.acceleration;
  const double a1 = h * h * b.acceleration;
  const double c3 = 10 * rise - 6 * v0 - 4 * v1 - 1.5 * a0 + 0.5 * a1;
  const double c4 = -15 * rise + 8 * v0 + 7 * v1 + 1.5 * a0 - a1;
  const double c5 = 6 * rise - 3 * v0 - 3 * v1 - 0.5 * a0 + 0.5 * a1;
  return [=](double u) { return u * (v0 + u * (a0 / 2 + u * (c3 + u * (c4 + u * c5)))); };
}

/// Through values at equal steps of [0, 1] (Lagrange).
Curve through(std::vector<double> values) {
  return [values = std::move(values)](double u) {
    const double place = u * static_cast<double>(values.size() - 1);
    double sum = 0;
    for (std::size_t j = 0; j < values.size(); ++j) {
      double term = values[j];
      for (std::size_t k = 0; k < values.size(); ++k) {
        if (k == j) continue;
        term *=
            (place - static_cast<double>(k)) / (static_cast<double>(j) - static_cast<double>(k));
      }
      sum += term;
    }
    return sum;
  };
}

/// One quantity along one branch.
class Extremes {
 public:
  Extremes(const Phi& phi, const Path& path, const Quantity& quantity)
      : phi_(phi), path_(path), quantity_(quantity), values_(values_along(path, quantity)) {}

  Course course() const { return {values_.front(), values_.back(), extreme(-1), extreme(1)}; }

 private:
  double extreme(double sign) const;
  bool may_exceed(const Piece& piece, double sign, double best) const;
  double beyond_samples(std::size_t a, double sign) const;
  double beside_event(const Piece& piece, double sign) const;

  const Phi& phi_;
  const Path& path_;
  const Quantity& quantity_;
  const std::vector<double> values_;
};

/// Where `curve` is largest between two places, for sign = 1; smallest for -1.
std::pair<double, double> extreme_of(const Curve& curve, double from, double to, double sign) {
  constexpr int kBits = 26;  // half of a double's: the place of an extreme is known no better
  const auto found = boost::math::tools::brent_find_minima(
      [&](double u) { return -sign * curve(u); }, from, to, kBits);
  return {found.first, -sign * found.second};
}

/// Between two samples a smooth value goes beyond both by less than it goes between them and their neighbours.
bool Extremes::may_exceed(const Piece& piece, double sign, double best) const {
  const std::size_t from = piece.first == 0 ? 0 : piece.first - 1;
  const std::size_t to = std::min(piece.last + 1, values_.size() - 1);
  double reach = 0;
  for (std::size_t k = from; k < to; ++k) {
    reach = std::max(reach, std::abs(values_[k + 1] - values_[k]));
  }
  const double nearest = std::max(sign * values_[piece.first], sign * values_[piece.last]);
  return nearest + reach >= sign * best;
}

double Extremes::beyond_samples(std::size_t k, double sign) const {
  const Station& a = path_.stations[k];
  const Station& b = path_.stations[k + 1];
  const double rise = values_[k + 1] - values_[k];
  const double known = values_[k] + (sign * rise > 0 ? rise : 0);
  const auto rates_a = rates_at(a, quantity_);
  const auto rates_b = rates_at(b, quantity_);
  if (!rates_a || !rates_b || rates_a->velocity * rates_b->velocity > 0) return known;
  const Curve curve = hermite(rise, *rates_a, *rates_b, b.time - a.time);
  const auto [u, excess] = extreme_of(curve, 0, 1, sign);
  const double found = values_[k] + excess;
  const double size = quantity_.kind == CoordinateKind::angle ? 1 : phi_.length();
  if (sign * (found - known) <= kFar * size) return found;
  const VectorXd guess = a.q + u * (b.q - a.q);
  const auto q = put_right(phi_, guess, a.time + u * (b.time - a.time), (b.q - a.q).norm());
  return q ? values_[k] + difference(quantity_, quantity_.value(*q), values_[k]) : known;
}

double Extremes::beside_event(const Piece& piece, double sign) const {
  const auto first = values_.begin() + static_cast<std::ptrdiff_t>(piece.first);
  std::vector<double> values(first, first + kParts + 1);
  // u = 0 is the event.
  if (path_.stations[piece.first].sample != nullptr) std::reverse(values.begin(), values.end());
  const auto best = std::max_element(values.begin(), values.end(),
                                     [sign](double a, double b) { return sign * a < sign * b; });
  constexpr double kPart = 1.0 / kParts;
  const double u = kPart * static_cast<double>(best - values.begin());
  return extreme_of(through(values), std::max(0.0, u - kPart), std::min(1.0, u + kPart), sign)
      .second;
}

double Extremes::extreme(double sign) const {
  const auto is_less = [sign](double a, double b) { return sign * a < sign * b; };
  double best = *std::max_element(values_.begin(), values_.end(), is_less);
  for (const Piece& piece : path_.pieces) {
    if (piece.is_at_event) {
      best = std::max(best, beside_event(piece, sign), is_less);
    } else if (piece.last == piece.first + 1 && may_exceed(piece, sign, best)) {
      best = std::max(best, beyond_samples(piece.first, sign), is_less);
    }
  }
  return best;
}

Quantity coordinate_quantity(const Coordinate& coordinate, const std::string& name,
                             std::size_t index) {
  const auto i = static_cast<Eigen::Index>(index);
  return {name, coordinate.kind, coordinate.is_periodic, true,
          [i](const VectorXd& q) { return q[i]; }};
}

}  // namespace

std::vector<Quantity> body_quantities(const Mechanism& mechanism) {
  std::vector<Quantity> all;
  const std::vector<Coordinate> names = coordinates(mechanism);
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (is_typed(mechanism)) {
      all.push_back(coordinate_quantity(names[k], names[k].name, k));
    } else if (names[k].kind == CoordinateKind::angle) {
      all.push_back(coordinate_quantity(names[k], mechanism.bodies[names[k].group + 1].name, k));
    }
  }
  return all;
}

std::vector<Quantity> joint_quantities(const Mechanism& mechanism) {
  std::vector<Quantity> all;
  if (is_typed(mechanism)) return all;
  const bool is_planar = mechanism.space == Space::planar;
  for (const Joint& joint : mechanism.joints) {
    const bool is_revolute = joint.type == JointType::revolute;
    const bool is_told = is_planar && is_revolute && joint.at[0].body * joint.at[1].body == 0;
    const VectorXd origin =
        VectorXd::Zero(static_cast<Eigen::Index>(coordinates(mechanism).size()));
    if (is_told || !joint_coordinate(mechanism, joint, origin)) continue;
    all.push_back({joint.name, is_revolute ? CoordinateKind::angle : CoordinateKind::length,
                   is_revolute, false, [&mechanism, &joint](const VectorXd& q) {
                     return *joint_coordinate(mechanism, joint, q);
                   }});
  }
  return all;
}

std::vector<Course> courses(const Phi& phi, const MotionBranch& branch,
                            const std::vector<Quantity>& quantities) {
  const Path path = path_of(phi, branch);
  std::vector<Course> all;
  for (const Quantity& quantity : quantities) {
    all.push_back(Extremes(phi, path, quantity).course());
  }
  return all;
}

std::vector<Course> driver_courses(const Mechanism& mechanism, const MotionBranch& branch) {
  std::vector<double> times{branch.begins};
  for (const BranchSample& sample : branch.samples) times.push_back(sample.time);
  times.push_back(branch.ends);
  std::vector<Course> all;
  for (const Driver& driver : mechanism.drivers) {
    std::vector<double> values;
    for (const double time : times) values.push_back(driver_state(driver.law, time).value);
    const auto [lower, upper] = std::minmax_element(values.begin(), values.end());
    all.push_back({values.front(), values.back(), *lower, *upper});
  }
  return all;
}

}  // namespace moivre
