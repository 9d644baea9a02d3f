// SPDX-License-Identifier: MIT
// What does a tracker promise? Sessions that follow the paths of a homotopy (tracker/session.h),
// and the account of its options and its work.
//
// H(x, t): the homotopy; H_x and H_t: its derivatives.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace moivre {

class Homotopy;
class TrackerSession;

/// Numbers stay numbers.
using OptionValue = std::variant<std::string, double, std::int64_t>;

struct OptionInForce {
  std::string name;
  OptionValue value;
};

using OptionsInForce = std::vector<OptionInForce>;

/// What was evaluated and factored.
struct WorkCount {
  std::uint64_t values = 0;          ///< H alone
  std::uint64_t fine_values = 0;     ///< H alone, in double-double
  std::uint64_t linearizations = 0;  ///< H, H_x, H_t
  std::uint64_t factorizations = 0;

  WorkCount& operator+=(const WorkCount& other);
  friend WorkCount operator-(const WorkCount& a, const WorkCount& b) {
    return {a.values - b.values, a.fine_values - b.fine_values, a.linearizations - b.linearizations,
            a.factorizations - b.factorizations};
  }
};

struct StepCount {
  std::uint64_t accepted = 0;
  std::uint64_t rejected = 0;
  WorkCount work;

  StepCount& operator+=(const StepCount& other);
};

class Tracker {
 public:
  virtual ~Tracker() = default;
  /// "cvode", "lanes".
  virtual std::string kind() const = 0;
  /// Name and value of every option in force, for the report.
  virtual OptionsInForce options_in_force() const = 0;
  /// A session on `homotopy`, which must outlive it. Thread-safe.
  virtual std::unique_ptr<TrackerSession> open(const Homotopy& homotopy) const = 0;
  /// The same tracker with all of a path in double-double; nullptr if there is none.
  virtual std::unique_ptr<Tracker> in_double_double() const { return nullptr; }
};

}  // namespace moivre
