// SPDX-License-Identifier: MIT
// Between which times do closures become real that no checkpoint shows? Every pair of complex ones
// is followed (pair_curve.h).
//
// Let B be the times at which some pair meets, turns back, goes to infinity or is lost, or a branch
// begins or ends. Between two neighbouring times of B the number of real closures is the same. So
// with one checkpoint there, and all its pairs followed, nothing is missed:
// two roots that are real for a while at another time are a pair in that checkpoint, or in the
// checkpoint of an earlier while, and following it leads there. The checkpoint has to be regular:
// as many closures as any other checkpoint, complex ones too, and no multiple one. And its pairs
// must not be lost at once. Else closures are solved at other times of that stretch, a few times.
// If its pairs can be followed from none of them, what is known is what these checkpoints show; if
// none is regular, that is a doubt.
// Stretches shorter than kBriefest have no checkpoint of their own; the roots that are real there
// come from the pair's own curve. But where three roots are real these are well apart, and a
// checkpoint shows them, however short that is.
// Every pair that passes a regular checkpoint must be one of its pairs.
// Curves that come by a place where complex closures nearly meet are lost there one by one, a
// little apart: that is one time of B, and of what lies between them the checkpoints alone are
// known. Edges: closures beyond a joint's limits are no branches; that they come within limits for
// a while is seen at checkpoints alone.
// A mechanism without drivers, or with fewer equations than unknowns, has no pairs that move.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "motion_sentences.h"
#include "pair_curve.h"
#include "solved_checkpoint.h"

namespace moivre {

class PairSearch {
 public:
  /// Both must outlive it.
  PairSearch(const MotionRun& run, const Tracker& tracker);
  PairSearch(const PairSearch&) = delete;  // the equations refer to the polynomials
  PairSearch& operator=(const PairSearch&) = delete;

  /// Follows the pairs of all checkpoints that no earlier curve passes.
  void follow(const std::vector<SolvedCheckpoint>& checkpoints);
  /// Times in stretches of B without a checkpoint, and in fold-backs: where to solve closures next;
  /// empty where nothing is left to see.
  std::vector<double> open_times();
  /// Branches that live so briefly that no checkpoint shows them, from the pair's curve; each is
  /// given once.
  std::vector<Track> take_brief();

  /// Times at which a pair meets and parts again, as far as rounding tells.
  const std::vector<double>& instants() const { return instants_; }
  /// Notes a doubt, once.
  void tell(const std::string& doubt);
  /// The stretches in which pairs can be followed from none of several checkpoints; nullopt where
  /// there is none.
  std::optional<SampledStretches> sampled() const;
  /// What was not found among a checkpoint's closures, each a sentence.
  std::vector<std::string> doubts() const;

 private:
  struct KnownPair {
    std::size_t block = 0;
    Point x;
    bool is_passed = false;
  };
  struct PairScene {
    double time = 0;
    bool is_complete = false;
    bool are_apart = true;     ///< its closures
    std::size_t closures = 0;  ///< distinct ones, complex ones too
    std::vector<KnownPair> pairs;
    bool lacks_pair = false;  ///< a curve passes that is none of its pairs
    bool leads_on = true;     ///< its pairs can be followed from it
  };
  struct Stretch {
    double from = 0;
    double to = 0;
    std::uint64_t checkpoints = 0;
  };
  bool is_regular(const PairScene& solved) const;
  void lose(double time);
  std::vector<double> event_times() const;
  bool shows(const PairScene& solved, double from, double to,
             const std::vector<double>& events) const;
  std::optional<double> next_time(double from, double to);
  void prepare();
  void enter(const SolvedCheckpoint& solved);
  void enter_pairs(const Point& root, PairScene& solved);
  void follow(std::size_t solved, std::size_t pair);
  bool pass(std::size_t solved, std::size_t block, const Point& x, const KnownPair& begun);
  void take(const PairEquations& equations, const PairCurve& curve);
  void take_brief(const PairEquations& equations, const RealWhile& life);
  std::vector<BranchPose> poses_above(const PairEquations& equations, const Point& x, double time);

  const MotionRun& run_;
  const Tracker& tracker_;
  std::unique_ptr<MovingPolynomials> polynomials_;  ///< null before something is complex
  std::vector<Block> blocks_;
  std::vector<std::unique_ptr<PairEquations>> equations_;  ///< of each block; null: it has no pairs
  std::vector<PairScene> checkpoints_;
  std::vector<double> borders_;
  std::vector<double> fold_backs_;
  std::vector<double> instants_;
  std::vector<RealWhile> brief_lives_;
  std::vector<Track> brief_;
  std::vector<std::string> doubts_;
  std::vector<Stretch> sampled_;
  std::vector<Stretch>
      lost_;  ///< where curves were lost, near places together: where complex closures nearly meet
  std::vector<std::string> unclear_;  ///< stretches without a regular checkpoint, likewise
};

/// From one dead point to the other through `pose`, too short for steps between.
Track brief_track(const Phi& phi, const BranchPose& begin, const BranchPose& pose,
                  const BranchPose& end);

/// A hundred branches begin and end between as many times; where numbers are too rough to follow
/// anything more would be without end.
inline constexpr std::size_t kMostSearches = 400;

/// Checkpoints until there is one between any two neighbouring events, with every pair of complex
/// closures followed. What is left open is told as a doubt.
void search_pairs(MotionRun& run, const Tracker& tracker,
                  std::vector<SolvedCheckpoint>& checkpoints, PairSearch& pairs,
                  std::size_t most_times = kMostSearches);

}  // namespace moivre
