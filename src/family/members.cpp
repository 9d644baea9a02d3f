// SPDX-License-Identifier: MIT
// Paths of many members in one session a thread; members in doubt go to solve_member().
#include "moivre/family/members.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <mutex>

#include "certified_members.h"
#include "moivre/expression/counted.h"
#include "moivre/numeric/invalid_input.h"
#include "moivre/numeric/threads.h"
#include "moivre/tracker/session.h"
#include "observed_members.h"

namespace moivre {
namespace {

// Members that a thread takes at once from those that are left.
constexpr std::size_t kBlock = 16;
// As in the endgame: a regular end, and one that is not beside infinity.
constexpr double kRegularCondition = 1e8;
constexpr double kLeastFiniteness = 1e-8;
constexpr double kNewtonTolerance = 1e-12;
// Ends nearer than this, relative, may be one root.
constexpr double kApart = 1e-6;
// Imaginary parts up to so many times the accuracy may be 0, of roots that are kApart from their
// conjugates otherwise.
constexpr double kRealTolerance = 1e-9;

struct Shared {
  const Family& family;
  std::span<const Point> members;
  const Tracker& tracker;
  const SolveOptions& options;
  const std::atomic<bool>& stop;
  const Homotopy homotopy;
  const std::vector<Point> starts;
  std::vector<MemberRoots>& results;
  std::atomic<std::size_t> next{0};
  std::mutex progress_mutex;
  Progress progress;
  std::atomic<bool> has_thrown{false};  ///< the callback: no other member begins

  bool is_over() const { return stop.load(std::memory_order_relaxed) || has_thrown; }

  void report(std::uint64_t finite) {
    if (!options.progress) return;
    const std::lock_guard lock(progress_mutex);
    if (has_thrown) return;
    ++progress.done;
    progress.finite += finite;
    try {
      options.progress(progress);
    } catch (...) {
      has_thrown = true;
      throw;
    }
  }
};

double size_of(const Point& x) { return std::max(1.0, max_norm(x)); }

double distance(const Point& a, const Point& b, double least) {
  double largest = 0;
  for (std::size_t j = 0; j < a.size() && largest <= least; ++j) {
    largest = std::max(largest, std::abs(a[j] - b[j]));
  }
  return largest;
}

bool are_apart(const std::vector<MemberRoot>& roots) {
  for (std::size_t k = 0; k < roots.size(); ++k) {
    const double least = kApart * size_of(roots[k].x);
    for (std::size_t l = 0; l < k; ++l) {
      if (distance(roots[k].x, roots[l].x, least) <= least) return false;
    }
  }
  return true;
}

bool is_conjugate(const Point& a, const Point& b, double least) {
  return std::equal(a.begin(), a.end(), b.begin(), [&](const Complex& x, const Complex& y) {
    return std::abs(x - std::conj(y)) <= least;
  });
}

void tell_real_ones(std::vector<MemberRoot>& roots) {
  for (MemberRoot& root : roots) {
    double imaginary = 0;
    for (const Complex& xj : root.x) imaginary = std::max(imaginary, std::abs(xj.imag()));
    root.real = imaginary <= kRealTolerance * size_of(root.x);
    if (!root.real) continue;
    for (Complex& xj : root.x) xj.imag(0);
  }
}

/// Whether each root of a real member has its conjugate.
bool are_conjugates_there(const std::vector<MemberRoot>& roots) {
  return std::all_of(roots.begin(), roots.end(), [&](const MemberRoot& root) {
    return root.real || std::any_of(roots.begin(), roots.end(), [&](const MemberRoot& other) {
             return is_conjugate(root.x, other.x, kApart * size_of(root.x));
           });
  });
}

/// One thread's paths. A member's slot is its result; what a path needs beside it is here.
class MemberSource : public SegmentSource {
 public:
  explicit MemberSource(Shared& shared)
      : shared_(shared), scratch_(shared.homotopy), is_real_(is_real(shared.family.system)) {}

  std::optional<PathSegment> next() override {
    const std::size_t paths = shared_.starts.size();
    if (path_ == paths && !begin_member()) return std::nullopt;
    PathSegment segment;
    segment.path = member_ * paths + path_;
    segment.x = shared_.starts[path_];
    segment.tolerance_level = shared_.options.tolerance_level;
    segment.frame = frame_;
    ++path_;
    return segment;
  }

  void arrived(const PathSegment& segment, SegmentResult&& reached) override {
    const std::size_t paths = shared_.starts.size();
    const std::size_t member = segment.path / paths;
    MemberRoots& result = shared_.results[member];
    if (!take(segment, std::move(reached), result.roots[segment.path % paths])) ++result.failed;
    // at_infinity counts the paths that have come home until all have.
    if (++result.at_infinity < paths) return;
    result.at_infinity = 0;
    finish(member, result);
  }

 private:
  bool begin_member() {
    if (shared_.is_over()) return false;
    if (++member_ >= block_end_) {
      const std::size_t block = shared_.next.fetch_add(kBlock, std::memory_order_relaxed);
      if (block >= shared_.members.size()) return false;
      member_ = block;
      block_end_ = std::min(block + kBlock, shared_.members.size());
    }
    shared_.results[member_].roots.resize(shared_.starts.size());
    PathFrame frame;
    frame.member = shared_.members[member_];
    frame_ = std::make_shared<const PathFrame>(std::move(frame));
    path_ = 0;
    return true;
  }

  /// False where the end is no regular root, as far as its condition tells.
  bool take(const PathSegment& segment, SegmentResult&& reached, MemberRoot& root) {
    if (reached.status != SegmentStatus::arrived) return false;
    scratch_.set_frame(segment.frame.get());
    CorrectorOptions newton;
    newton.tolerance = kNewtonTolerance;
    const Correction correction = scratch_.correct(reached.x, {1.0, 0.0}, newton, true);
    const Chart& chart = shared_.homotopy.chart();
    const double finiteness = chart.finiteness(reached.x);
    root.condition = scratch_.condition();
    if (!correction.converged || finiteness < kLeastFiniteness) return false;
    root.accuracy = correction.last / finiteness;
    root.x = std::move(reached.x);
    const Complex x0 = root.x.back();
    root.x.pop_back();
    for (Complex& xj : root.x) xj /= x0;
    return root.condition <= kRegularCondition;
  }

  void finish(std::size_t member, MemberRoots& result) {
    const Point& p = shared_.members[member];
    const bool is_real_member = is_real_ && std::all_of(p.begin(), p.end(), [](const Complex& pj) {
                                  return pj.imag() == 0;
                                });
    tell_real_ones(result.roots);
    result.complete = result.failed == 0 && are_apart(result.roots) &&
                      (!is_real_member || are_conjugates_there(result.roots));
    if (result.complete) shared_.report(result.roots.size());
  }

  Shared& shared_;
  PathSystem scratch_;
  bool is_real_;
  std::size_t member_ = 0, block_end_ = 0;
  std::size_t path_ = shared_.starts.size();
  FramePointer frame_;
};

void judge(Shared& shared, std::size_t member) {
  SolveOptions options = shared.options;
  options.threads = 1;
  options.progress = nullptr;
  const SolveResult solved = solve_member(shared.family, exact_values(shared.members[member]),
                                          shared.tracker, options, shared.stop);
  MemberRoots& result = shared.results[member];
  result = {};
  result.judged = true;
  result.complete = solved.complete;
  result.completeness = solved.completeness;
  result.at_infinity = solved.paths.at_infinity;
  result.not_needed = solved.paths.not_needed;
  result.failed = solved.paths.failed;
  for (const Solution& root : solved.solutions) {
    result.roots.push_back({root.x, root.real, root.singular, root.multiplicity, root.accuracy,
                            root.condition, root.certified});
  }
  shared.report(result.roots.size());
}

/// solve_member() may throw only what was thrown before any work.
void judge_the_rest(Shared& shared, int threads) {
  std::vector<std::size_t> rest;
  for (std::size_t k = 0; k < shared.results.size(); ++k) {
    if (!shared.results[k].complete) rest.push_back(k);
  }
  std::atomic<std::size_t> next{0};
  on_threads(std::min<int>(threads, static_cast<int>(rest.size())), [&] {
    for (std::size_t k = next++; k < rest.size() && !shared.is_over(); k = next++) {
      judge(shared, rest[k]);
    }
  });
}

/// What becomes of members that their paths alone do not decide.
enum class AnyDoubt { stays, is_judged };

/// Of members whose paths did not all come to a regular root: the others are no roots, or may be
/// none.
void keep_what_arrived(AnyDoubt doubt, std::vector<MemberRoots>& results) {
  const bool keeps_doubtful_ends = doubt == AnyDoubt::stays;
  for (MemberRoots& result : results) {
    if (result.complete) continue;
    result.at_infinity = 0;
    std::erase_if(result.roots, [&](const MemberRoot& root) {
      const bool is_doubtful = !(root.condition <= kRegularCondition);
      return root.x.empty() || (is_doubtful && !keeps_doubtful_ends);
    });
    tell_real_ones(result.roots);
  }
}

/// Of a member that was not judged. Where the family may lack roots its members may.
void tell_completeness(const Family& family, bool is_certified, MemberRoots& result) {
  if (result.judged) return;
  const auto certified = static_cast<std::uint64_t>(
      std::count_if(result.roots.begin(), result.roots.end(),
                    [](const MemberRoot& root) { return root.certified == true; }));
  const Learning& learning = family.learning;
  const bool is_proved = learning.bound && learning.bound->value == certified;
  result.complete = result.complete && (is_proved || learning.complete);
  if (!is_certified) return;
  result.completeness = is_proved         ? RootCompleteness::proved
                        : result.complete ? RootCompleteness::shown
                                          : RootCompleteness::open;
}

std::vector<Point> homogeneous(const std::vector<Point>& roots) {
  std::vector<Point> points = roots;
  for (Point& point : points) {
    point.push_back(1);
    const double scale = 1 / euclidean_norm(point);
    for (Complex& xj : point) xj *= scale;
  }
  return points;
}

void require_fitting(const Family& family, std::span<const Point> members) {
  require_unbroken(broken_rules(family));
  for (std::size_t k = 0; k < members.size(); ++k) {
    if (!std::isfinite(max_norm(members[k]))) {
      throw InvalidInput("member " + std::to_string(k) + " has a parameter that is not finite");
    }
    if (members[k].size() == family.parameters()) continue;
    throw InvalidInput("member " + std::to_string(k) + " has " +
                       counted(members[k].size(), "parameter") + ", the family " +
                       std::to_string(family.parameters()));
  }
}

std::vector<MemberRoots> roots_of(const Family& family, std::span<const Point> members,
                                  const Tracker& tracker, const SolveOptions& options,
                                  const std::atomic<bool>& stop, AnyDoubt doubt) {
  require_unbroken(validate(options));
  require_fitting(family, members);
  std::vector<MemberRoots> results(members.size());
  if (members.empty()) return results;
  if (options.observations != nullptr) {
    const Homotopy homotopy = Homotopy::members(family.system, family.generic);
    const MembersTask task{family, homotopy, tracker, options, doubt == AnyDoubt::is_judged};
    return observe_members(
        task, members,
        [&](std::span<const Point> block, const SolveOptions& of_block) {
          return roots_of(family, block, tracker, of_block, stop, doubt);
        },
        stop);
  }
  const int threads = thread_count(options.threads);
  Shared shared{family,
                members,
                tracker,
                options,
                stop,
                Homotopy::members(family.system, family.generic),
                homogeneous(family.roots),
                results,
                {},
                {},
                {},
                {}};
  shared.progress.total = members.size();
  const auto blocks = static_cast<int>(std::min<std::size_t>(members.size() / kBlock + 1, 1024));
  if (!family.roots.empty()) {
    on_threads(std::min(threads, blocks), [&] {
      MemberSource source(shared);
      run_session(*tracker.open(shared.homotopy), source, stop);
    });
    keep_what_arrived(doubt, results);
    if (options.certify) certify_members(family, members, threads, stop, results);
  }
  if (doubt == AnyDoubt::is_judged) judge_the_rest(shared, threads);
  for (MemberRoots& result : results) tell_completeness(family, options.certify, result);
  return results;
}

}  // namespace

std::uint64_t MemberRoots::real_count() const {
  return static_cast<std::uint64_t>(
      std::count_if(roots.begin(), roots.end(), [](const MemberRoot& root) { return root.real; }));
}

std::vector<MemberRoots> follow_members(const Family& family, std::span<const Point> members,
                                        const Tracker& tracker, const SolveOptions& options,
                                        const std::atomic<bool>& stop) {
  return roots_of(family, members, tracker, options, stop, AnyDoubt::stays);
}

std::vector<MemberRoots> solve_members(const Family& family, std::span<const Point> members,
                                       const Tracker& tracker, const SolveOptions& options,
                                       const std::atomic<bool>& stop) {
  return roots_of(family, members, tracker, options, stop, AnyDoubt::is_judged);
}

}  // namespace moivre
