// SPDX-License-Identifier: MIT
// Members as jobs: a list's fingerprint, bytes of roots, and blocks of what is not known.
#include "observed_members.h"

#include <algorithm>

#include "moivre/numeric/bytes.h"
#include "moivre/numeric/job_list.h"
#include "moivre/numeric/threads.h"
#include "moivre/tracker/followed.h"

namespace moivre {
namespace {

// Paths of a block, which is lost where the run is killed: some seconds at most. Lanes are full in
// a block of so many members a thread.
constexpr std::size_t kPathsTogether = 20'000, kMembersOfAThread = 16, kMostTogether = 4096;

Fingerprint list_of(const MembersTask& task, std::span<const Point> members) {
  FingerprintMaker maker;
  maker.add(std::string_view("members"));
  add_to(maker, task.homotopy);
  add_to(maker, task.tracker);
  if (task.options.fallback != nullptr) add_to(maker, *task.options.fallback);
  maker.add(task.options.seed);
  maker.add(static_cast<double>(task.options.tolerance_level));
  maker.add(std::uint64_t{task.options.certify});
  maker.add(std::uint64_t{task.is_judged});
  for (const Point& root : task.family.roots) maker.add(root);
  for (const Point& member : members) maker.add(member);
  return maker.fingerprint();
}

/// Among other processes blocks are as small as lanes allow, so that all end together.
std::size_t least_block_of(const MembersTask& task) {
  return kMembersOfAThread * static_cast<std::size_t>(thread_count(task.options.threads));
}

std::size_t block_of(const MembersTask& task) {
  const std::size_t paths = std::max<std::size_t>(1, task.family.roots.size());
  return std::min(std::max(kPathsTogether / paths, least_block_of(task)), kMostTogether);
}

OutcomeKind kind_of(const MemberRoots& roots) {
  return roots.complete ? OutcomeKind::root : OutcomeKind::failed;
}

/// The options of a block, of which `done` members with `finite` roots are known already.
SolveOptions of_block(const SolveOptions& options, std::size_t done, std::size_t total,
                      std::uint64_t finite) {
  SolveOptions block = options;
  block.observations = nullptr;
  if (!options.progress) return block;
  block.progress = [&options, done, total, finite](const Progress& of) {
    Progress whole = of;
    whole.done += done;
    whole.total = total;
    whole.finite += finite;
    options.progress(whole);
  };
  return block;
}

}  // namespace

std::string bytes_of(const MemberRoots& roots) {
  ByteWriter bytes;
  bytes.put(static_cast<std::uint64_t>(roots.roots.size()));
  for (const MemberRoot& root : roots.roots) {
    bytes.put(root.x);
    bytes.put(root.real);
    bytes.put(root.singular);
    bytes.put(root.multiplicity);
    bytes.put(root.accuracy);
    bytes.put(root.condition);
    bytes.put(root.certified ? (*root.certified ? 1 : 0) : -1);
  }
  bytes.put(roots.at_infinity);
  bytes.put(roots.not_needed);
  bytes.put(roots.failed);
  bytes.put(roots.complete);
  bytes.put(roots.judged);
  bytes.put(roots.completeness ? static_cast<int>(*roots.completeness) : -1);
  return bytes.bytes();
}

MemberRoots member_roots_of(std::string_view text) {
  ByteReader bytes(text);
  MemberRoots roots;
  for (auto left = bytes.get<std::uint64_t>(); left > 0; --left) {
    MemberRoot& root = roots.roots.emplace_back();
    root.x = bytes.get_vector<Complex>();
    root.real = bytes.get<bool>();
    root.singular = bytes.get<bool>();
    root.multiplicity = bytes.get<std::uint64_t>();
    root.accuracy = bytes.get<double>();
    root.condition = bytes.get<double>();
    const int certified = bytes.get<int>();
    if (certified >= 0) root.certified = certified == 1;
  }
  roots.at_infinity = bytes.get<std::uint64_t>();
  roots.not_needed = bytes.get<std::uint64_t>();
  roots.failed = bytes.get<std::uint64_t>();
  roots.complete = bytes.get<bool>();
  roots.judged = bytes.get<bool>();
  const int completeness = bytes.get<int>();
  if (completeness >= 0) roots.completeness = static_cast<RootCompleteness>(completeness);
  bytes.require_end();
  return roots;
}

std::vector<MemberRoots> observe_members(const MembersTask& task, std::span<const Point> members,
                                         const MembersSolver& solve,
                                         const std::atomic<bool>& stop) {
  std::vector<MemberRoots> results(members.size());
  std::size_t done = 0;
  std::uint64_t finite = 0;
  const auto count = [&](const MemberRoots& result) {
    finite += result.roots.size();
    ++done;
  };
  const auto take = [&](std::size_t member, std::string_view outcome) {
    results[member] = member_roots_of(outcome);
    count(results[member]);
    return kind_of(results[member]);
  };
  const auto solve_block = [&](std::span<const std::size_t> numbers) {
    std::vector<Point> block;
    for (const std::size_t k : numbers) block.push_back(members[k]);
    auto solved = solve(block, of_block(task.options, done, members.size(), finite));
    std::vector<JobOutcome> outcomes;
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      MemberRoots& result = results[numbers[k]];
      result = std::move(solved[k]);
      count(result);
      if (!stop) outcomes.push_back({numbers[k], bytes_of(result), kind_of(result)});
    }
    return outcomes;
  };
  do_jobs({list_of(task, members), members.size(), block_of(task), least_block_of(task), take,
           solve_block},
          *task.options.observations, stop);
  if (!stop) task.options.observations->lists_are_done();
  return results;
}

}  // namespace moivre
