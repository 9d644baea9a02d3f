// SPDX-License-Identifier: MIT
// What asks a run to stop with what is finished? Ctrl-C and its like, a limit of time, and memory
// that runs out.
//
//   SIGINT, SIGTERM, SIGHUP   the first one asks the run to stop, the second ends the program at
//                             once; SIGHUP does not, where the run was begun with nohup
//   a limit of time           asks as the first signal does
//   a ledger                  that cannot be written any more asks too
//   memory                    looked at now and then, by a signal too (SIGPROF, by processor time):
//                             what is left has to suffice for telling what is finished. Where an
//                             allocation fails all the same a reserve is given up for that
//
// There is no thread that watches: beside a second thread each allocation takes locks.
//
// While results are written a signal gives up what is not written within a second from then
// (is_writing_interrupted()).
#pragma once

#include <atomic>
#include <optional>

namespace moivre {

/// Catches all this while it lives; one at a time.
class Interruption {
 public:
  /// seconds: from now on, after which the run is to stop.
  explicit Interruption(std::optional<double> seconds = std::nullopt);
  /// Tells on stderr where it was not a signal that stopped the run.
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  const std::atomic<bool>& stop() const;

 private:
  std::optional<double> seconds_;
};

/// As a signal would, but without a word: who calls tells why.
void stop_run();
bool is_asked_to_stop();

/// Results are written while it lives.
class Writing {
 public:
  Writing();
  ~Writing();
  Writing(const Writing&) = delete;
  Writing& operator=(const Writing&) = delete;
};

/// Whether a signal came since the writing began, so long ago that it is to end.
bool is_writing_interrupted();

}  // namespace moivre
