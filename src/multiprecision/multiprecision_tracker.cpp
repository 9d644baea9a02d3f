// SPDX-License-Identifier: MIT
// The tracker of fine_tracker.h in MPFR's numbers.
#include "moivre/multiprecision/multiprecision_tracker.h"

#include "big_complex.h"
#include "moivre/homotopy/write_program.h"
#include "moivre/numeric/invalid_input.h"
#include "moivre/tracker/fine_tracker.h"

namespace moivre {
namespace {

// To thirty roots within 1e-6 a path takes 250. One that takes many more goes along beside another
// sheet, and more digits do not shorten its way.
constexpr std::int64_t kMostSteps = 1000;
constexpr unsigned kSome = 100;
constexpr unsigned kMany = 300;
static_assert(kTrackedDigits == std::array{int{kSome}, int{kMany}});

template <unsigned D>
std::unique_ptr<Tracker> make_tracker() {
  return std::make_unique<FineTracker<BigComplex<D>>>(
      std::to_string(D) + " digits", FineTrackerOptions{.maximum_steps = kMostSteps});
}

}  // namespace

std::unique_ptr<Tracker> make_multiprecision_tracker(int digits) {
  switch (digits) {
    case kSome:
      return make_tracker<kSome>();
    case kMany:
      return make_tracker<kMany>();
    default:
      throw InvalidInput("paths are followed in " + std::to_string(kSome) + " or " +
                         std::to_string(kMany) + " digits, not in " + std::to_string(digits));
  }
}

}  // namespace moivre
