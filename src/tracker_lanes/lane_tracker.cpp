// SPDX-License-Identifier: MIT
// The lane tracker, compiled once for every instruction set; the best that the machine has is
// chosen when it runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lane_tracker.cpp"
#include "moivre/tracker_lanes/lane_tracker.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "lane_double_double-inl.h"
#include "lane_session-inl.h"
#include "lane_target.h"

#ifndef MOIVRE_LANE_FUNCTIONS
#define MOIVRE_LANE_FUNCTIONS
namespace moivre {

/// What there is once for every instruction set.
struct LaneFunctions {
  TrackerSession* (*open_session)(const LaneOptions&, const Homotopy&);
  TrackerSession* (*open_fine_session)(const LaneOptions&, const Homotopy&);
  std::size_t width;
  const char* target_name;
};

}  // namespace moivre
#endif

HWY_BEFORE_NAMESPACE();
namespace moivre {
namespace HWY_NAMESPACE {

TrackerSession* open_session(const LaneOptions& options, const Homotopy& homotopy) {
  return new LaneSession<V>(options, homotopy);
}
TrackerSession* open_fine_session(const LaneOptions& options, const Homotopy& homotopy) {
  return new LaneSession<LaneDoubleDouble>(options, homotopy);
}

LaneFunctions functions() {
  return {&open_session, &open_fine_session, W, hwy::TargetName(HWY_TARGET)};
}

}  // namespace HWY_NAMESPACE
}  // namespace moivre
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <algorithm>

#include "moivre/numeric/invalid_input.h"
#include "moivre/tracker/option_table.h"

namespace moivre {
namespace {

/// Of the best instruction set that was compiled and that may be run.
LaneFunctions lane_functions() {
#if (HWY_TARGETS & (HWY_TARGETS - 1)) == 0
  return HWY_STATIC_DISPATCH(functions)();
#else
  // As HWY_EXPORT lays out its tables: nothing, the targets from the best on, the baseline.
  constexpr LaneFunctions (*kTable[])() = {nullptr, HWY_CHOOSE_TARGET_LIST(functions),
                                           HWY_CHOOSE_FALLBACK(functions)};
  hwy::ChosenTarget chosen;
  chosen.Update(runnable_targets());
  return kTable[chosen.GetIndex()]();
#endif
}

class LaneTracker : public Tracker {
 public:
  LaneTracker(const LaneOptions& options, bool fine) : options_(options), fine_(fine) {}

  std::string kind() const override { return "lanes"; }
  OptionsInForce options_in_force() const override;
  std::unique_ptr<TrackerSession> open(const Homotopy& homotopy) const override {
    const LaneFunctions functions = lane_functions();
    return std::unique_ptr<TrackerSession>(fine_ ? functions.open_fine_session(options_, homotopy)
                                                 : functions.open_session(options_, homotopy));
  }
  std::unique_ptr<Tracker> in_double_double() const override {
    LaneOptions options = options_;
    options.tolerance = std::min(options.tolerance, kFineLaneTolerance);
    return std::make_unique<LaneTracker>(options, true);
  }

 private:
  LaneOptions options_;
  bool fine_;  // in double-double
};

OptionsInForce LaneTracker::options_in_force() const {
  OptionsInForce options{{"target", lane_target()},
                         {"lanes", static_cast<std::int64_t>(lane_width())}};
  for (OptionInForce& chosen : in_force(lane_table(), options_)) {
    options.push_back(std::move(chosen));
  }
  if (fine_) options.push_back({"precision", "double-double"});
  return options;
}

}  // namespace

std::string lane_target() { return lane_functions().target_name; }
std::size_t lane_width() { return lane_functions().width; }

std::vector<std::string> lane_targets() {
  std::vector<std::string> names;
  for (auto rest = runnable_targets() & HWY_TARGETS; rest != 0; rest &= rest - 1) {
    names.emplace_back(hwy::TargetName(rest & -rest));
  }
  return names;
}

std::unique_ptr<Tracker> make_lane_tracker(const LaneOptions& options) {
  require_unbroken(validate(options));
  return std::make_unique<LaneTracker>(options, false);
}

}  // namespace moivre
#endif
