// SPDX-License-Identifier: MIT
// What is one constraint of Phi? Rows that depend on few coordinates, written once for every
// scalar.
//
// A row formula is a generic callable rows(at, out): `at` gives coordinates and time in the scalar
// S, `out` takes the rows.
// Its dimensions are Jets of the line along which it is differentiated: constants, but for the one
// that moves (dimension_jets.h).
#pragma once

#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "moivre/mechanism/gradient.h"
#include "moivre/mechanism/jet.h"
#include "moivre/mechanism/mechanism.h"

namespace moivre {

/// All coordinates and the time, in the scalar S.
template <class S>
struct At {
  std::span<const S> q;
  S t;
};

/// A row of Phi, and the power of a length that its value is: 2 of a rod, 1 of a displacement, 0 of
/// an angle.
struct RowLabel {
  std::string name;
  int power = 0;
};

class Constraint {
 public:
  Constraint(std::vector<RowLabel> row_labels, std::vector<std::size_t> coordinates)
      : labels(std::move(row_labels)), depends_on(std::move(coordinates)) {}
  Constraint(const Constraint&) = delete;
  Constraint& operator=(const Constraint&) = delete;
  virtual ~Constraint() = default;

  virtual void evaluate(const At<Jet>& at, Jet* rows) const = 0;
  virtual void evaluate(const At<Gradient>& at, Gradient* rows) const = 0;
  virtual void evaluate(const At<Magnitude>& at, Magnitude* rows) const = 0;

  const std::vector<RowLabel> labels;         ///< one a row
  const std::vector<std::size_t> depends_on;  ///< indices of the coordinates that the rows read
};

template <class Rows>
class ConstraintOf final : public Constraint {
 public:
  ConstraintOf(std::vector<RowLabel> row_labels, std::vector<std::size_t> coordinates, Rows rows)
      : Constraint(std::move(row_labels), std::move(coordinates)), rows_(std::move(rows)) {}

  void evaluate(const At<Jet>& at, Jet* rows) const override { rows_(at, rows); }
  void evaluate(const At<Gradient>& at, Gradient* rows) const override { rows_(at, rows); }
  void evaluate(const At<Magnitude>& at, Magnitude* rows) const override { rows_(at, rows); }

 private:
  Rows rows_;
};

using Constraints = std::vector<std::shared_ptr<const Constraint>>;

template <class Rows>
std::shared_ptr<const Constraint> make_constraint(std::vector<RowLabel> labels,
                                                  std::vector<std::size_t> coordinates, Rows rows) {
  return std::make_shared<const ConstraintOf<Rows>>(std::move(labels), std::move(coordinates),
                                                    std::move(rows));
}

/// A dimension beside coordinates in the scalar S: a plain number, but for a Jet, along whose line
/// it may move.
template <class S>
auto in_scalar(const Jet& dimension) {
  if constexpr (std::is_same_v<S, Jet>) {
    return dimension;
  } else {
    return dimension.f;
  }
}

/// What a driver prescribes, and how fast that moves beside the time.
struct Prescription {
  DriverLaw law;
  double rate = 0;
};

/// The prescribed value carried by the scalar of the time: Taylor terms along t for a Jet.
inline Jet law_at(const Prescription& prescribed, const Jet& t) {
  const DriverState state = driver_state(prescribed.law, t.f);
  Jet value = chain(t, state.value, state.velocity, state.acceleration);
  value.d += prescribed.rate;
  return value;
}
/// `rate` is of a dimension, and a gradient has none of these.
inline Gradient law_at(const Prescription& prescribed, const Gradient& t) {
  const DriverState state = driver_state(prescribed.law, t.f);
  return chain(t, state.value, state.velocity, state.acceleration);
}
inline Magnitude law_at(const Prescription& prescribed, const Magnitude& t) {
  const DriverState state = driver_state(prescribed.law, t.f);
  return {state.value, std::abs(state.value) + std::abs(state.velocity * t.f)};
}

/// L |L|: no two points are a length below 0 apart.
template <class S>
S signed_square(const S& length) {
  return length.f < 0 ? -(length * length) : length * length;
}

/// Indices of the coordinates of the moving ones among `bodies`; `size` coordinates a body, ground
/// has none.
inline std::vector<std::size_t> coordinates_of(const std::vector<std::size_t>& bodies,
                                               std::size_t size) {
  std::vector<std::size_t> indices;
  for (const std::size_t body : bodies) {
    if (body == 0) continue;
    for (std::size_t k = 0; k < size; ++k) indices.push_back(size * (body - 1) + k);
  }
  return indices;
}

struct Dimension;

/// The joint's rows, the driver's row. `moving`: the dimension that changes at rate 1 along the
/// line; null where none does.
std::shared_ptr<const Constraint> joint_constraint(const Mechanism& mechanism, const Joint& joint,
                                                   const Dimension* moving = nullptr);
std::shared_ptr<const Constraint> driver_constraint(const Mechanism& mechanism,
                                                    const Driver& driver,
                                                    const Dimension* moving = nullptr);

/// The row that holds a spin (spins.h).
std::shared_ptr<const Constraint> spin_constraint(const Mechanism& mechanism, const Spin& spin);

/// Likewise, of a planar or spatial mechanism.
std::shared_ptr<const Constraint> planar_joint(const Mechanism& mechanism, const Joint& joint,
                                               const Dimension* moving);
std::shared_ptr<const Constraint> spatial_joint(const Mechanism& mechanism, const Joint& joint,
                                                const Dimension* moving);
std::shared_ptr<const Constraint> planar_driver(const Mechanism& mechanism, const Driver& driver,
                                                const Dimension* moving);
std::shared_ptr<const Constraint> spatial_driver(const Mechanism& mechanism, const Driver& driver,
                                                 const Dimension* moving);

}  // namespace moivre
