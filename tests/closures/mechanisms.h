// SPDX-License-Identifier: MIT
// Mechanisms for tests: files of problems/mechanisms, and texts.
#pragma once

#include <string>

#include "../mechanism/files.h"
#include "moivre/closures/closures.h"
#include "moivre/tracker_cvode/cvode_tracker.h"

namespace moivre {

inline Mechanism mechanism_file(const std::string& name) { return test::example(name); }

inline Mechanism mechanism_text(const std::string& text) { return test::typed(text); }

/// The file's driver number `driver` starts at `start_rad` instead.
inline Mechanism driven_from(Mechanism mechanism, double start_rad, std::size_t driver = 0) {
  mechanism.drivers.at(driver).law = Parabola{start_rad, 0, 0};
  return mechanism;
}

/// The text with every `what` replaced.
inline std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
  return text;
}

inline ClosureResult closures_of(const Mechanism& mechanism, std::uint64_t seed = 1,
                                 double time = 0) {
  ClosureOptions options;
  options.time = time;
  options.solve.seed = seed;
  options.solve.threads = 1;
  options.with_mobility = true;
  return find_closures(mechanism, *make_cvode_tracker(), options);
}

}  // namespace moivre
