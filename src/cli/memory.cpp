// SPDX-License-Identifier: MIT
// What Linux tells of memory: /proc, the limit of the address space, and that of the control group.
#include "memory.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>
#include <string_view>

namespace moivre {
namespace {

constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();
constexpr std::uint64_t kKilobyte = 1024;

std::uint64_t left(std::uint64_t limit, std::uint64_t used) {
  return limit > used ? limit - used : 0;
}

/// How a file begins. Signal handlers read it too: no stream, no memory.
class Beginning {
 public:
  explicit Beginning(const char* path) {
    const int file = ::open(path, O_RDONLY | O_CLOEXEC);
    if (file < 0) return;
    length_ = ::read(file, text_, sizeof text_);
    ::close(file);
  }

  /// The number behind the first such word, with blanks before it; nothing where there is none.
  std::optional<std::uint64_t> number_behind(std::string_view word = "") const {
    const std::string_view text(text_, static_cast<std::size_t>(std::max<ssize_t>(0, length_)));
    const std::size_t at = text.find(word);
    const std::size_t digits = text.find_first_not_of(' ', std::min(at, text.size()) + word.size());
    std::uint64_t number = 0;
    if (at == text.npos || digits == text.npos) return std::nullopt;
    const auto [end, error] =
        std::from_chars(text.data() + digits, text.data() + text.size(), number);
    return error == std::errc() ? std::optional(number) : std::nullopt;
  }

 private:
  char text_[512];
  ssize_t length_ = 0;
};

/// Of the machine, without swapping.
std::uint64_t left_by_machine() {
  const auto size = Beginning("/proc/meminfo").number_behind("MemAvailable:");
  return size ? *size * kKilobyte : kUnlimited;
}

/// Of the control group at the root, as a container sees its own.
std::uint64_t left_by_group() {
  const auto limit = Beginning("/sys/fs/cgroup/memory.max").number_behind();
  const auto used = Beginning("/sys/fs/cgroup/memory.current").number_behind();
  return limit && used ? left(*limit, *used) : kUnlimited;
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
  const Beginning pages("/proc/self/statm");
  const std::uint64_t addresses = pages.number_behind().value_or(0);
  const std::uint64_t resident = pages.number_behind(" ").value_or(0);
  return {resident * page,
          std::min({left_by_machine(), left_by_group(), left_by_limit(addresses * page)})};
}

void spare_addresses() {
#ifdef __GLIBC__
  if (limit_of_addresses() != kUnlimited) ::mallopt(M_ARENA_MAX, 1);
#endif
}

}  // namespace moivre
