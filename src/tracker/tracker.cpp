// SPDX-License-Identifier: MIT
// The trackers' shared vocabulary: sums of counts, a single segment, and what a source throws.
#include "moivre/tracker/tracker.h"

#include <exception>

#include "moivre/tracker/session.h"

namespace moivre {

StepCount& StepCount::operator+=(const StepCount& other) {
  accepted += other.accepted;
  rejected += other.rejected;
  work += other.work;
  return *this;
}

namespace {

class SingleSegment : public SegmentSource {
 public:
  explicit SingleSegment(PathSegment&& segment) : segment_(std::move(segment)) {}

  std::optional<PathSegment> next() override {
    std::optional<PathSegment> result;
    result.swap(segment_);
    return result;
  }
  void arrived(const PathSegment&, SegmentResult&& reached) override {
    reached_ = std::move(reached);
  }
  SegmentResult take() { return std::move(reached_); }

 private:
  std::optional<PathSegment> segment_;
  SegmentResult reached_;
};

/// Hands on what another source does, until that throws.
class CaughtSource : public SegmentSource {
 public:
  explicit CaughtSource(SegmentSource& source) : source_(source) {}

  std::optional<PathSegment> next() override {
    if (thrown_) return std::nullopt;
    try {
      return source_.next();
    } catch (...) {
      thrown_ = std::current_exception();
      return std::nullopt;
    }
  }
  void arrived(const PathSegment& segment, SegmentResult&& reached) override {
    if (thrown_) return;
    try {
      source_.arrived(segment, std::move(reached));
    } catch (...) {
      thrown_ = std::current_exception();
    }
  }
  void rethrow() const {
    if (thrown_) std::rethrow_exception(thrown_);
  }

 private:
  SegmentSource& source_;
  std::exception_ptr thrown_;
};

}  // namespace

void run_session(TrackerSession& session, SegmentSource& source, const std::atomic<bool>& stop) {
  CaughtSource caught(source);
  session.run(caught, stop);
  caught.rethrow();
}

SegmentResult follow(TrackerSession& session, PathSegment segment, const std::atomic<bool>& stop) {
  SingleSegment source(std::move(segment));
  run_session(session, source, stop);
  return source.take();
}

}  // namespace moivre
