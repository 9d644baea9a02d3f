// SPDX-License-Identifier: MIT
// What is one constraint of Phi? Rows that depend on few coordinates, written once for every scalar.
//
// A row formula is a generic callable rows(at, out): `at` gives coordinates and time in the scalar S, `out` takes the rows.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "moivre/mechanism/jet.h"
#include "moivre/mechanism/mechanism.h"

namespace moivre {

/// All coordinates and the time, in the scalar S.
template <class S>
struct At {
  std::span<const S> q;
  S t;
};

class Constraint {
 public:
  Constraint(std::vector<std::string> names, std::vector<std::size_t> coordinates)
      : row_names(std::move(names)), depends_on(std::move(coordinates)) {}
  Constraint(const Constraint&) = delete;
  Constraint& operator=(const Constraint&) = delete;
  virtual ~Constraint() = default;

  virtual void evaluate(const At<Jet>& at, Jet* rows) const = 0;
  virtual void evaluate(const At<Magnitude>& at, Magnitude* rows) const = 0;

  const std::vector<std::string> row_names;
  const std::vector<std::size_t> depends_on;  ///< indices of the coordinates that the rows read
};

template <class Rows>
class ConstraintOf final : public Constraint {
 public:
  ConstraintOf(std::vector<std::string> names, std::vector<std::size_t> coordinates, Rows rows)
      : Constraint(std::move(names), std::move(coordinates)), rows_(std::move(rows)) {}

  void evaluate(const At<Jet>& at, Jet* rows) const override { rows_(at, rows); }
  void evaluate(const At<Magnitude>& at, Magnitude* rows) const override { rows_(at, rows); }

 private:
  Rows rows_;
};

using Constraints = std::vector<std::shared_ptr<const Constraint>>;

template <class Rows>
std::shared_ptr<const Constraint> make_constraint(std::vector<std::string> names,
                                                  std::vector<std::size_t> coordinates, Rows rows) {
  return std::make_shared<const ConstraintOf<Rows>>(std::move(names), std::move(coordinates),
                                                    std::move(rows));
}

/// The value of a driver law carried by the scalar of the time: Taylor terms along t for a Jet.
inline Jet law_at(const DriverLaw& law, const Jet& t) {
  const DriverState state = driver_state(law, t.f);
  return chain(t, state.value, state.velocity, state.acceleration);
}
inline Magnitude law_at(const DriverLaw& law, const Magnitude& t) {
  const DriverState state = driver_state(law, t.f);
  return {state.value, std::abs(state.value) + std::abs(state.velocity * t.f)};
}

/// Indices of the coordinates of the moving ones among `bodies`; `size` coordinates a body, ground has none.
inline std::vector<std::size_t> coordinates_of(const std::vector<std::size_t>& bodies,
                                               std::size_t size) {
  std::vector<std::size_t> indices;
  for (const std::size_t body : bodies) {
    if (body == 0) continue;
    for (std::size_t k = 0; k < size; ++k) indices.push_back(size * (body - 1) + k);
  }
  return indices;
}

/// The joint's rows of a planar or spatial mechanism.
std::shared_ptr<const Constraint> planar_joint(const Mechanism& mechanism, const Joint& joint);
std::shared_ptr<const Constraint> spatial_joint(const Mechanism& mechanism, const Joint& joint);
/// The driver's row.
std::shared_ptr<const Constraint> planar_driver(const Mechanism& mechanism, const Driver& driver);
std::shared_ptr<const Constraint> spatial_driver(const Mechanism& mechanism, const Driver& driver);

}  // namespace moivre
