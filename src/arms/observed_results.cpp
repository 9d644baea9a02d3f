// SPDX-License-Identifier: MIT
// One list of fields, by which results are written and read.
#include "observed_results.h"

#include <numeric>

#include "moivre/numeric/bytes.h"
#include "moivre/numeric/job_list.h"
#include "moivre/tracker/followed.h"

namespace moivre {
namespace {

template <class T>
concept IsPlain = std::is_arithmetic_v<T> || std::is_enum_v<T>;

/// Writes each value that it is given.
class Writing {
 public:
  template <class... Fields>
  void operator()(const Fields&... values) {
    (put(values), ...);
  }
  const std::string& bytes() const { return bytes_.bytes(); }

 private:
  template <IsPlain T>
  void put(const T& value) {
    bytes_.put(value);
  }
  void put(const std::string& text) { bytes_.put(std::string_view(text)); }
  template <class T, int Rows, int Columns>
  void put(const Eigen::Matrix<T, Rows, Columns>& matrix) {
    bytes_.put(static_cast<std::uint64_t>(matrix.rows()));
    bytes_.put(std::vector<T>(matrix.data(), matrix.data() + matrix.size()));
  }
  template <class T>
  void put(const std::optional<T>& value) {
    bytes_.put(value.has_value());
    if (value) put(*value);
  }
  template <class T>
  void put(const std::vector<T>& values) {
    bytes_.put(static_cast<std::uint64_t>(values.size()));
    for (const T& value : values) put(value);
  }
  template <class T>
  void put(const T& value) {
    each_field(value, *this);
  }

  ByteWriter bytes_;
};

/// Reads each value that it is given.
class Reading {
 public:
  explicit Reading(std::string_view bytes) : bytes_(bytes) {}
  template <class... Fields>
  void operator()(Fields&... values) {
    (get(values), ...);
  }
  void require_end() const { bytes_.require_end(); }

 private:
  template <IsPlain T>
  void get(T& value) {
    value = bytes_.get<T>();
  }
  void get(std::string& text) { text = bytes_.get_text(); }
  template <class T, int Rows, int Columns>
  void get(Eigen::Matrix<T, Rows, Columns>& matrix) {
    const auto rows = static_cast<Eigen::Index>(bytes_.get<std::uint64_t>());
    const std::vector<T> values = bytes_.get_vector<T>();
    const auto size = static_cast<Eigen::Index>(values.size());
    // A vector has its one column also where it is empty.
    const Eigen::Index columns = Columns != Eigen::Dynamic ? Columns : rows > 0 ? size / rows : 0;
    const bool has_rows = rows >= 0 && (Rows == Eigen::Dynamic || rows == Rows);
    const bool is_full = columns == 0 ? size == 0 : rows == size / columns && size % columns == 0;
    if (!has_rows || !is_full) {
      throw std::invalid_argument("kept bytes are not what was written");
    }
    matrix = Eigen::Map<const Eigen::Matrix<T, Rows, Columns>>(values.data(), rows, columns);
  }
  template <class T>
  void get(std::optional<T>& value) {
    if (!bytes_.get<bool>()) return;
    get(value.emplace());
  }
  template <class T>
  void get(std::vector<T>& values) {
    for (auto left = bytes_.get<std::uint64_t>(); left > 0; --left) get(values.emplace_back());
  }
  template <class T>
  void get(T& value) {
    each_field(value, *this);
  }

  ByteReader bytes_;
};

template <class T, class Wanted>
concept Is = std::is_same_v<std::remove_const_t<T>, Wanted>;

void each_field(Is<Twist> auto& twist, auto& each) { each(twist.translation, twist.rotation); }

void each_field(Is<WeakestMotion> auto& motion, auto& each) { each(motion.joints, motion.tip); }

void each_field(Is<ArmClosure> auto& closure, auto& each) {
  each(closure.id, closure.values, closure.in_limits, closure.beyond, closure.residual,
       closure.newton_iterations, closure.smallest_singular_value, closure.weakest, closure.path,
       closure.multiplicity, closure.singular, closure.moved_by_digits, closure.within_digits);
}

void each_field(Is<PathCounts> auto& paths, auto& each) {
  each(paths.tracked, paths.finite, paths.at_infinity, paths.failed, paths.not_needed,
       paths.by_count, paths.on_positive_dimensional, paths.retracked, paths.handed_over,
       paths.mixed, paths.double_double, paths.multiprecision);
}

void each_field(Is<ArmStage> auto& stage, auto& each) {
  each(stage.group, stage.solves, stage.paths);
}

void each_field(Is<ArmCounts> auto& counts, auto& each) {
  each(counts.complex, counts.real, counts.beyond_limits, counts.rejected);
}

void each_field(Is<JointRelation> auto& relation, auto& each) {
  each(relation.factors, relation.value);
}

void each_field(Is<SelfMotion> auto& set, auto& each) {
  each(set.dimension, set.values, set.directions, set.lost, set.relations, set.samples, set.closes,
       set.misfit, set.within_digits);
}

void each_field(Is<PoseMisfit> auto& misfit, auto& each) { each(misfit.position, misfit.rotation); }

void each_field(Is<NearestPosture> auto& nearest, auto& each) {
  each(nearest.values, nearest.misfit, nearest.apart);
}

void each_field(Is<StartCount> auto& count, auto& each) { each(count.paths, count.missing); }

void each_field(Is<StartFacts> auto& start, auto& each) {
  each(start.source, start.paths, start.why, start.counts.total_degree,
       start.counts.multihomogeneous, start.counts.mixed_volume);
}

/// Bytes of the two parts of a number are those of a plane vector.
template <class T>
requires std::is_same_v<std::remove_const_t<T>, FailedPath>
void each_field(T& path, auto& each) {
  Eigen::Vector2d t(path.t.real(), path.t.imag());
  each(path.path, path.failure, t, path.stage);
  if constexpr (!std::is_const_v<T>) path.t = {t.x(), t.y()};
}

void each_field(Is<LeftOut> auto& step, auto& each) { each(step.what, step.why); }

void each_field(Is<StepCount> auto& count, auto& each) {
  each(count.accepted, count.rejected, count.work.values, count.work.fine_values,
       count.work.linearizations, count.work.factorizations);
}

void each_field(Is<SolveTime> auto& time, auto& each) {
  each(time.threads, time.parse, time.start, time.track, time.track_cpu, time.refine, time.total);
}

void each_field(Is<ArmResult> auto& result, auto& each) {
  each(result.complete, result.message, result.accuracy, result.start, result.paths, result.stages,
       result.counts, result.closures, result.moves, result.nearest, result.failures,
       result.left_out, result.work, result.time_s);
}

void add_to(FingerprintMaker& maker, const Eigen::Isometry3d& place) {
  for (const double number : place.matrix().reshaped()) maker.add(number);
}

OutcomeKind kind_of(const ArmResult& result) {
  return result.complete ? OutcomeKind::root : OutcomeKind::failed;
}

/// A result is passed on by its place: those behind a job that was cut short wait in the ledger.
void take_before_first_gap(std::vector<std::optional<ArmResult>>&& results,
                           const std::function<void(ArmResult&& result)>& take) {
  for (std::optional<ArmResult>& result : results) {
    if (!result) break;
    take(std::move(*result));
  }
}

}  // namespace

void observe_results(const ResultJobs& jobs, const Tracker& tracker, const SolveOptions& options,
                     const std::atomic<bool>& stop,
                     const std::function<void(ArmResult&& result)>& take) {
  if (options.observations == nullptr) {
    std::vector<std::size_t> all(jobs.count);
    std::iota(all.begin(), all.end(), std::size_t{0});
    take_before_first_gap(jobs.solve(all), take);
    return;
  }
  std::vector<std::optional<ArmResult>> results(jobs.count);
  const auto read = [&](std::size_t job, std::string_view outcome) {
    ArmResult& result = results[job].emplace(arm_result_of(outcome));
    result.pose = jobs.pose(job);
    result.seed = options.seed;
    result.tracker = tracker.kind();
    result.tracker_options = tracker.options_in_force();
    jobs.tell();
    return kind_of(result);
  };
  const auto solve = [&](std::span<const std::size_t> numbers) {
    std::vector<JobOutcome> outcomes;
    auto solved = jobs.solve(numbers);
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      std::optional<ArmResult>& result = results[numbers[k]];
      result = std::move(solved[k]);
      if (!result || stop) continue;
      outcomes.push_back({numbers[k], bytes_of(*result), kind_of(*result)});
    }
    return outcomes;
  };
  do_jobs({jobs.list, jobs.count, jobs.together, jobs.together, read, solve}, *options.observations,
          stop);
  take_before_first_gap(std::move(results), take);
}

void add_to(FingerprintMaker& maker, const Arm& arm) {
  for (const std::string& name : {arm.robot, arm.base, arm.tip}) maker.add(std::string_view(name));
  for (const ArmJoint& joint : arm.joints) {
    maker.add(std::uint64_t{joint.is_slide});
    maker.add(std::uint64_t{joint.limits.has_value()});
    if (joint.limits) {
      maker.add(joint.limits->lower);
      maker.add(joint.limits->upper);
    }
    add_to(maker, joint.before);
    for (const double number : joint.axis) maker.add(number);
  }
  add_to(maker, arm.tool);
  maker.add(arm.rounding);
}

void add_to(FingerprintMaker& maker, const TypedPose& pose) {
  add_to(maker, pose.pose);
  maker.add(pose.accuracy);
}

void add_to(FingerprintMaker& maker, const Tracker& tracker, const SolveOptions& options) {
  add_to(maker, tracker);
  if (options.fallback != nullptr) add_to(maker, *options.fallback);
  maker.add(options.seed);
  maker.add(static_cast<std::uint64_t>(options.start));
}

std::string bytes_of(const ArmResult& result) {
  Writing writing;
  writing(result);
  return writing.bytes();
}

ArmResult arm_result_of(std::string_view bytes) {
  ArmResult result;
  Reading reading(bytes);
  reading(result);
  reading.require_end();
  return result;
}

}  // namespace moivre
