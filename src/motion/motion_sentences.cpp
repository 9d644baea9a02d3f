// SPDX-License-Identifier: MIT
// The English of a motion's results.
#include "motion_sentences.h"

#include "moivre/expression/counted.h"
#include "moivre/expression/joined.h"
#include "moivre/mechanism/closure_id.h"

namespace moivre {
namespace {

std::string at_time(double time) { return "at t = " + std::to_string(time) + " s"; }

std::string between(double from, double to) {
  return "between t = " + std::to_string(from) + " s and " + std::to_string(to) + " s";
}

std::string branch_at(const std::string& branch, double time) {
  return "branch " + branch + " " + at_time(time);
}

std::string guess_name(std::size_t guess) { return "guess " + std::to_string(guess); }

std::string counted_branches(std::uint64_t count) { return counted(count, "branch", "branches"); }

}  // namespace

std::string motion_message(MotionVerdict verdict) {
  switch (verdict) {
    case MotionVerdict::interrupted:
      return "interrupted: what is finished is reported";
    case MotionVerdict::followed:
      return "every branch was followed to an event or to the end";
    case MotionVerdict::undecided:
      return "not everything was decided: see failures";
    case MotionVerdict::not_assembled:
      return "cannot be assembled at any checkpoint";
  }
  return {};
}

std::string followed_to_the_end() { return "followed to the end"; }

std::string not_followed_from_closure() {
  return "not followed: the pose is too close to singular, or its lengths differ too much, to tell "
         "it from a crossing of branches";
}

std::string branch_failure(const std::string& branch, double time, const std::string& message) {
  return branch_at(branch, time) + ": " + message;
}

std::string branch_without_closure(const std::string& branch, double time) {
  return branch_at(branch, time) + " is at no closure of its own that was found there";
}

std::string branch_takes_another_way(const std::string& branch) {
  return "branch " + branch + ": followed back from its last checkpoint it takes another way";
}

std::string branch_unmet_at_dead_point(const std::string& branch, double time) {
  return branch_at(branch, time) + ": the branch that meets it in its dead point was not found";
}

std::string closure_on_no_branch(const std::string& closure, double time) {
  return "closure " + closure + " " + at_time(time) + " is on no branch";
}

std::string closures_failure(double time, const std::string& message) {
  return "closures " + at_time(time) + ": " + message;
}

std::string sub_chain_failure(const std::string& body, const std::string& failure) {
  return "sub-chain of " + body + ": " + failure;
}

std::string one_to_one(std::uint64_t closures, std::uint64_t branches) {
  return "one to one: " + counted(closures, "closure") + ", " + counted_branches(branches);
}

std::string one_to_one_in_sub_chains(std::uint64_t closures, std::uint64_t listed) {
  return "one to one in each sub-chain: " + counted(closures, "closure") + ", " +
         counted_branches(listed) + " listed";
}

std::string pair_not_solved(double time) {
  return "a pair of complex closures that is there " + at_time(time) +
         " is not among those that were solved";
}

std::string brief_closures_incomplete(double time) {
  return "closures are real " + at_time(time) +
         " for less than a millionth of the motion, and not all of them were found";
}

std::string brief_meeting_not_found(double time) {
  return "closures are real " + at_time(time) +
         " for less than a millionth of the motion, and where they meet was not found";
}

std::string no_regular_time(std::uint64_t times, double from, double to) {
  return "some closures are at infinity, or double, at each of the " + counted(times, "time") +
         " that were solved " + between(from, to);
}

std::string events_without_end(std::uint64_t times, std::optional<double> unsolved) {
  return "closures were solved between neighbouring events " + counted(times, "time") +
         ", and more events came to light each time" +
         (unsolved ? "; none was solved " + at_time(*unsolved) : "");
}

LeftOut short_branches_left_out(const SampledStretches& sampled) {
  const std::string parts =
      sampled.count == 1 ? "" : "in " + std::to_string(sampled.count) + " stretches ";
  return {"a short branch, if there is one", "pairs of complex closures cannot be followed " +
                                                 parts + between(sampled.from, sampled.to) +
                                                 "; closures were solved there " +
                                                 counted(sampled.checkpoints, "time")};
}

LeftOut touching_closures_left_out(double time) {
  return {"closures " + at_time(time),
          "complex closures meet there and separate again: a pose for an instant"};
}

LeftOut instants_left_out(std::uint64_t closures, double time) {
  return {counted(closures, "closure") + " " + at_time(time),
          "the constraints are compatible for an instant only: no branch passes through"};
}

LeftOut crossed_checkpoint_left_out(double time) {
  return {"the checkpoint " + at_time(time),
          "branches cross there and closures are not all isolated or apart: they were compared on "
          "both sides of it"};
}

LeftOut hidden_branches_left_out() {
  return {
      "branches that begin and end between two checkpoints, and meet no others except at a joint "
      "limit",
      "they may be missed: between two checkpoints, what joint limits hide is looked at only 16 "
      "times"};
}

LeftOut later_checkpoints_left_out() {
  return {"checkpoints",
          "none were asked for: branches that begin later are not found, and exchanged branches "
          "not noticed"};
}

std::string guess_failure(std::size_t guess, const std::string& newton_message) {
  return guess_name(guess) + ": Newton-Raphson " + newton_message;
}

LeftOut repeated_guess_left_out(std::size_t guess) {
  return {guess_name(guess), "it assembles where an earlier guess does"};
}

LeftOut closures_left_out_by_guesses() {
  return {"closures and checkpoints", "the motion starts from guesses: no polynomials were solved"};
}

LeftOut combined_branches_left_out(std::size_t most) {
  return {"some combinations of the sub-chains' branches",
          "beyond " + std::to_string(most) +
              " they are not all listed: each branch of a sub-chain is listed with one of each "
              "other that is there with it, and circuits are given for each sub-chain"};
}

LeftOut unreachable_branches_left_out(const std::vector<std::string>& branches,
                                      const std::vector<std::string>& asked_closures) {
  return {(branches.size() == 1 ? "branch " : "branches ") + joined(branches, ", "),
          "not on a circuit of closure " + joined(asked_closures, ", ") +
              ", which was asked for alone"};
}

std::string known_closures(const std::vector<std::string>& ids, bool are_more) {
  if (ids.empty()) return "there is none at all";
  return "there are " + joined(ids, ", ") + (are_more ? ", ..." : "");
}

std::string names_in_sub_chains(const std::vector<std::string>& of) {
  return "; " + joined(of, ".") + " names one closure of each sub-chain, " +
         sub_chain_name(0, of.front()) + " all with this one of the first";
}

std::string circuit_note(CircuitNote note) {
  switch (note) {
    case CircuitNote::turn_ends_in_other_poses:
      return "the turn ends in other poses than it began with, as gears do: circuits go on beyond "
             "it";
    case CircuitNote::motion_incomplete:
      return "the motion is not complete: circuits that are listed apart may be one";
    case CircuitNote::no_closures:
      return "no closures were solved: there may be other circuits";
    case CircuitNote::drivers_move_together:
      return "the drivers move together as prescribed: another motion of theirs may join circuits";
    case CircuitNote::more_than_one_turn:
      return "the drivers go more than one turn: a circuit may be listed once per turn";
    case CircuitNote::drivers_do_not_return:
      return "the drivers do not come back to where they began: circuits may be joined outside of "
             "this range";
    case CircuitNote::not_all_listed:
      return "not all branches are listed: each sub-chain has circuits of its own";
  }
  return {};
}

std::string turning_driver_note(const std::string& driver) {
  return "driver '" + driver + "' turns back: a circuit that it goes through twice is listed twice";
}

}  // namespace moivre
