// SPDX-License-Identifier: MIT
// What Linux tells of memory: /proc, the limit of the address space, and that of the control group.
#include "memory.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

namespace moivre {
namespace {

constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();
constexpr std::uint64_t kKilobyte = 1024;

std::uint64_t left(std::uint64_t limit, std::uint64_t used) {
  return limit > used ? limit - used : 0;
}

/// Of the machine, without swapping.
std::uint64_t left_by_machine() {
  std::ifstream file("/proc/meminfo");
  std::string word;
  std::uint64_t size = 0;
  while (file >> word) {
    if (word == "MemAvailable:" && file >> size) return size * kKilobyte;
  }
  return kUnlimited;
}

/// Of the control group at the root, as a container sees its own.
std::uint64_t left_by_group() {
  std::ifstream limit_file("/sys/fs/cgroup/memory.max");
  std::ifstream used_file("/sys/fs/cgroup/memory.current");
  std::uint64_t limit = 0;
  std::uint64_t used = 0;
  return limit_file >> limit && used_file >> used ? left(limit, used) : kUnlimited;
}

std::uint64_t limit_of_addresses() {
  struct rlimit limit = {};
  if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return kUnlimited;
  return limit.rlim_cur;
}

std::uint64_t left_by_limit(std::uint64_t address_space) {
  const std::uint64_t limit = limit_of_addresses();
  return limit == kUnlimited ? kUnlimited : left(limit, address_space);
}

}  // namespace

MemoryState memory_state() {
  const auto page = static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
  std::ifstream file("/proc/self/statm");
  std::uint64_t address_space = 0;
  std::uint64_t resident = 0;
  file >> address_space >> resident;
  return {resident * page,
          std::min({left_by_machine(), left_by_group(), left_by_limit(address_space * page)})};
}

void spare_addresses() {
#ifdef __GLIBC__
  if (limit_of_addresses() != kUnlimited) ::mallopt(M_ARENA_MAX, 1);
#endif
}

}  // namespace moivre
