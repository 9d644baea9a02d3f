// SPDX-License-Identifier: MIT
// The only signal handlers of Moivre, and the only handler of failed allocations.
#include "interruption.h"

#include <sys/time.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <new>

#include "memory.h"
#include "process_role.h"

namespace moivre {
namespace {

enum class Reason { none, signal, time, memory, ledger };

std::atomic<bool> interrupted{false};
std::atomic<Reason> stop_reason{Reason::none};
std::atomic<bool> signalled{false};
std::atomic<bool> is_writing{false};
// When a signal came since the writing began, by now_ms(); 0: none did.
std::atomic<std::int64_t> writing_interrupted_at{0};
std::atomic<void*> reserve{nullptr};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<Reason>::is_always_lock_free &&
                  std::atomic<std::int64_t>::is_always_lock_free,
              "a signal handler may touch nothing else");

// A limit of the size of files fails writes, and ends no program.
constexpr int kIgnored = SIGXFSZ;
constexpr int kSignals[]{SIGINT, SIGTERM, SIGHUP};
// Untouched, so that it takes address space only.
constexpr std::size_t kReserve = std::size_t{32} << 20;
// Processor time, of all threads: who takes memory works.
constexpr double kLook = 0.05;
// Results that take no longer are not lost to a signal.
constexpr std::int64_t kTimeToWriteMs = 800;
// What a run has in memory is told with less than a third of it again; of little of it the reserve
// is enough.
constexpr std::uint64_t kShareToTell = 3;
constexpr std::uint64_t kLeastToTell = std::uint64_t{8} << 20;

void ask_to_stop(Reason why) {
  Reason none = Reason::none;
  stop_reason.compare_exchange_strong(none, why);
  interrupted.store(true, std::memory_order_relaxed);
}

/// Above 0. Signal handlers ask it too.
std::int64_t now_ms() {
  struct timespec now = {};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{1000} * now.tv_sec + now.tv_nsec / 1'000'000 + 1;
}

void note_signal(int signal) {
  const bool is_first = !signalled.exchange(true);
  std::int64_t none = 0;
  const bool is_first_of_writing =
      is_writing && writing_interrupted_at.compare_exchange_strong(none, now_ms());
  if (is_first || is_first_of_writing) return ask_to_stop(Reason::signal);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void note_time(int) { ask_to_stop(Reason::time); }

void look_at_memory(int) {
  // What is left to do while results are written is to tell what there is.
  if (interrupted || is_writing) return;
  const int saved_errno = errno;
  const MemoryState memory = memory_state();
  if (memory.available < memory.used / kShareToTell + kLeastToTell) ask_to_stop(Reason::memory);
  errno = saved_errno;
}

/// Called where memory cannot be had: once for all threads the reserve is given up, and each tries
/// once more.
void give_up_reserve() {
  thread_local bool has_tried_again = false;
  void* const block = reserve.exchange(nullptr);
  std::free(block);
  ask_to_stop(Reason::memory);
  if (block == nullptr && has_tried_again) throw std::bad_alloc();
  has_tried_again = true;
}

/// The system's timers count microseconds, and take none of them for no timer. `again`: and again
/// after as many seconds.
void set_timer(__itimer_which_t clock, double seconds, bool again = false) {
  constexpr double kLongest = 1e9;  // some thirty years
  constexpr double kMicro = 1e6;
  const double whole = std::floor(std::min(seconds, kLongest));
  const double rest = std::clamp(seconds - whole, 0.0, 1.0);
  struct itimerval timer = {};
  timer.it_value.tv_sec = static_cast<time_t>(whole);
  timer.it_value.tv_usec = static_cast<suseconds_t>(std::min(std::ceil(rest * kMicro), kMicro - 1));
  if (again) timer.it_interval = timer.it_value;
  setitimer(clock, &timer, nullptr);
}

void end_timer(__itimer_which_t clock, int signal) {
  set_timer(clock, 0);
  // Its last signal may be on its way to another thread, and ends no program.
  std::signal(signal, SIG_IGN);
}

void catch_signal(int signal, void (*handler)(int)) {
  struct sigaction old = {};
  sigaction(signal, nullptr, &old);
  if (signal == SIGHUP && old.sa_handler == SIG_IGN) return;
  struct sigaction action = {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigaction(signal, &action, nullptr);
}

}  // namespace

Interruption::Interruption(std::optional<double> seconds)
    : seconds_(process_role().tells ? seconds : std::nullopt) {
  interrupted = signalled = false;
  writing_interrupted_at = 0;
  stop_reason = Reason::none;
  for (const int signal : kSignals) catch_signal(signal, note_signal);
  std::signal(kIgnored, SIG_IGN);
  if (seconds_) {
    catch_signal(SIGALRM, note_time);
    set_timer(ITIMER_REAL, *seconds_);
  }
  spare_addresses();
  reserve = std::malloc(kReserve);
  std::set_new_handler(give_up_reserve);
  catch_signal(SIGPROF, look_at_memory);
  set_timer(ITIMER_PROF, kLook, true);
}

Interruption::~Interruption() {
  end_timer(ITIMER_PROF, SIGPROF);
  std::set_new_handler(nullptr);
  std::free(reserve.exchange(nullptr));
  if (seconds_) end_timer(ITIMER_REAL, SIGALRM);
  for (const int signal : kSignals) {
    struct sigaction now = {};
    sigaction(signal, nullptr, &now);
    if (now.sa_handler == note_signal) std::signal(signal, SIG_DFL);
  }
  if (stop_reason == Reason::time) {
    std::fprintf(stderr, "moivre: the time limit of %g s was reached\n", *seconds_);
  }
  if (stop_reason == Reason::memory) std::fputs("moivre: memory ran out\n", stderr);
}

const std::atomic<bool>& Interruption::stop() const { return interrupted; }

void stop_run() { ask_to_stop(Reason::ledger); }

bool is_asked_to_stop() { return interrupted; }

Writing::Writing() {
  writing_interrupted_at = 0;
  is_writing = true;
}

Writing::~Writing() { is_writing = false; }

bool is_writing_interrupted() {
  const std::int64_t at = writing_interrupted_at;
  return at != 0 && now_ms() - at > kTimeToWriteMs;
}

}  // namespace moivre
