// SPDX-License-Identifier: MIT
// The only signal handlers of Moivre: a flag is set, and the signal's own action is restored.
#include "interruption.h"

#include <csignal>

namespace moivre {
namespace {

std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may touch nothing else");

void restore_default_action() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

void note_interruption(int) {
  interrupted.store(true, std::memory_order_relaxed);
  restore_default_action();
}

}  // namespace

Interruption::Interruption() {
  interrupted = false;
  struct sigaction action = {};
  action.sa_handler = note_interruption;
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

Interruption::~Interruption() { restore_default_action(); }

const std::atomic<bool>& Interruption::stop() const { return interrupted; }

}  // namespace moivre
