// SPDX-License-Identifier: MIT
// The program `moivre-mpi`: the commands of `moivre`, whose lists of jobs all ranks do together.
// Rank 0 tells.
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>

#include "command_line.h"
#include "interruption.h"
#include "moivre/mpi_ranks/mpi_ranks.h"
#include "process_role.h"

namespace moivre {
namespace {

class ObservedByRanks : public SharedObservations {
 public:
  explicit ObservedByRanks(MpiRanks& ranks) : ranks_(ranks) {}
  Observations* kept_in(Observations* ledger) override {
    ranks_.keep_in(ledger);
    return &ranks_;
  }

 private:
  MpiRanks& ranks_;
};

// Set: every rank tells on stderr, at its end, what it has sent and what time it took.
constexpr const char* kTrafficWanted = "MOIVRE_MPI_TRAFFIC";

/// What another rank than 0 has to say rank 0 says too.
void be_silent() {
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere < 0) return;
  ::dup2(nowhere, STDOUT_FILENO);
  if (std::getenv(kTrafficWanted) == nullptr) ::dup2(nowhere, STDERR_FILENO);
  ::close(nowhere);
}

void tell_traffic(const MpiRanks& ranks) {
  if (std::getenv(kTrafficWanted) == nullptr) return;
  const RankTraffic traffic = ranks.traffic();
  std::fprintf(stderr,
               "moivre-mpi: rank %d of %d: %llu messages of %llu bytes sent, %.3f s CPU, %.3f of "
               "it for messages\n",
               ranks.rank(), ranks.ranks(), static_cast<unsigned long long>(traffic.messages),
               static_cast<unsigned long long>(traffic.bytes),
               static_cast<double>(std::clock()) / CLOCKS_PER_SEC, traffic.cpu);
}

int run_as_rank(int argc, char** argv) {
  std::unique_ptr<MpiRanks> ranks;
  ranks = std::make_unique<MpiRanks>(&argc, &argv, [&ranks] {
    tell_traffic(*ranks);
    // The other threads may be at work, which is of no use any more.
    std::_Exit(kDecided);
  });
  ObservedByRanks observed(*ranks);
  const bool tells = ranks->rank() == 0;
  set_process_role({tells, &observed});
  if (!tells) be_silent();
  const int code = run_command_line(argc, argv);
  const bool is_answer = code == kDecided || code == kUndecided;
  const int failed = ranks->end(is_answer ? kDecided : code);
  tell_traffic(*ranks);
  if (failed > 0 && is_answer) {
    std::fprintf(stderr, "moivre-mpi: %d of %d ranks could not work on this\n", failed,
                 ranks->ranks());
  }
  return code;
}

}  // namespace
}  // namespace moivre

int main(int argc, char** argv) { return moivre::run_as_rank(argc, argv); }
