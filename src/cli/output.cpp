// SPDX-License-Identifier: MIT
// Output files by POSIX descriptors: tried early, written late, beside their place and moved there
// when they are whole.
#include "output.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <future>
#include <new>
#include <numeric>
#include <optional>
#include <set>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <utility>

#include "interruption.h"
#include "process_role.h"

namespace moivre {
namespace {

constexpr mode_t kReadWriteForAll = 0666;  // less what the umask takes away

[[noreturn]] void refuse_path(const std::string& path) {
  throw std::invalid_argument("cannot write " + path + ": " + std::strerror(errno));
}

/// A descriptor, closed at the end. Never 0, 1 or 2: where those are closed, messages would go into
/// the file.
class Descriptor {
 public:
  explicit Descriptor(int descriptor) : descriptor_(descriptor) {
    constexpr int kFirstFree = STDERR_FILENO + 1;
    if (descriptor_ < 0 || descriptor_ >= kFirstFree) return;
    descriptor_ = ::fcntl(descriptor, F_DUPFD_CLOEXEC, kFirstFree);
    ::close(descriptor);
  }
  ~Descriptor() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  Descriptor& operator=(Descriptor&& other) {
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }

  bool is_open() const { return descriptor_ >= 0; }
  int number() const { return descriptor_; }
  int release() { return std::exchange(descriptor_, -1); }

 private:
  int descriptor_;
};

int open_to_write(const std::string& path, int flags) {
  return Descriptor(::open(path.c_str(), O_WRONLY | O_CLOEXEC | flags, kReadWriteForAll)).release();
}

/// False, with errno, when not all could be written.
bool has_written_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

/// 0, or why there is no room. A timer's signal may come meanwhile.
int reserve_room(int descriptor, off_t size) {
  int refusal = 0;
  do {
    refusal = size == 0 ? 0 : ::posix_fallocate(descriptor, 0, size);
  } while (refusal == EINTR);
  return refusal;
}

/// False, with errno. A full disk may be told no earlier than here.
bool has_closed(Descriptor& file) { return ::close(file.release()) == 0; }

std::optional<struct stat> status_of(const std::string& path) {
  struct stat status = {};
  if (::stat(path.c_str(), &status) != 0) return std::nullopt;
  return status;
}

std::string folder_of(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

/// A name in the folder of `path` that no other draft has, of this process or another one.
std::string name_beside(const std::string& path) {
  static std::atomic<int> drafts{0};
  return folder_of(path) + "/.moivre-" + std::to_string(::getpid()) + "-" +
         std::to_string(++drafts);
}

/// Without a name, so that nothing stays behind where the process is killed; -1 where the file
/// system has no such files.
int open_nameless(const std::string& folder) {
#ifdef O_TMPFILE
  // Its name comes by way of /proc.
  return ::access("/proc/self/fd", X_OK) == 0 ? open_to_write(folder, O_TMPFILE) : -1;
#else
  return -1;
#endif
}

/// Gives a nameless file this name; false, with errno.
bool has_named(const Descriptor& file, const std::string& name) {
  const std::string self = "/proc/self/fd/" + std::to_string(file.number());
  return ::linkat(AT_FDCWD, self.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
}

/// False, with errno. Pipes and the like cannot be synchronized, nor need they.
bool has_synced(int descriptor) {
  return ::fsync(descriptor) == 0 || errno == EINVAL || errno == EROFS || errno == ENOSYS;
}

/// The entries of a folder, after a file was moved in it; where that fails the file is there all
/// the same.
void sync_folder(const std::string& folder) {
  const Descriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (descriptor.is_open()) ::fsync(descriptor.number());
}

/// Where the file itself is, or would be, behind links.
std::string behind_links(const std::string& path) {
  std::filesystem::path target = path;
  std::error_code error;
  while (std::filesystem::is_symlink(target, error)) {
    target = target.parent_path() / std::filesystem::read_symlink(target, error);
    if (error) return path;
  }
  return target.string();
}

/// Whether a new file in its place would be the same to everybody: no other name, no other owner.
bool takes_place_of(const Descriptor& file, const struct stat& old) {
  return old.st_nlink == 1 && ::fchown(file.number(), old.st_uid, old.st_gid) == 0 &&
         ::fchmod(file.number(), old.st_mode & 07777U) == 0;
}

/// Throws when not all of a piece could be written. `path` is the name in the message.
TextSink sink_of(const Descriptor& file, const std::string& path) {
  return [&file, &path](std::string_view piece) {
    if (is_writing_interrupted()) {
      throw std::invalid_argument("interrupted: " + path + " was not written");
    }
    if (!has_written_all(file.number(), piece)) refuse_path(path);
  };
}

/// A file beside its place, which is removed again unless it is moved there. It has no name before,
/// where that can be.
class Draft {
 public:
  explicit Draft(const std::string& target)
      : target_(target), name_(name_beside(target)), file_(open_nameless(folder_of(target))) {
    ::unlink(name_.c_str());
    is_nameless_ = file_.is_open();
    if (!is_nameless_) file_ = Descriptor(open_to_write(name_, O_CREAT | O_EXCL));
  }
  ~Draft() {
    if (!has_moved_) ::unlink(name_.c_str());
  }
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;

  const Descriptor& file() const { return file_; }
  /// When it is on the disk; false, with errno. A full disk may be told no earlier than here.
  bool has_moved() {
    if (!has_synced(file_.number())) return false;
    if (is_nameless_ && !has_named(file_, name_)) return false;
    if (!has_closed(file_)) return false;
    has_moved_ = ::rename(name_.c_str(), target_.c_str()) == 0;
    if (has_moved_) sync_folder(folder_of(target_));
    return has_moved_;
  }

 private:
  std::string target_;
  std::string name_;
  Descriptor file_;
  bool is_nameless_ = false;
  bool has_moved_ = false;
};

/// Written beside and moved: false where that cannot be done here. Throws when the text cannot be
/// written.
bool is_replaced(const std::string& path, const Content& content) {
  const std::string target = behind_links(path);
  Draft draft(target);
  if (!draft.file().is_open()) return false;
  const auto old = status_of(target);
  if (old && !takes_place_of(draft.file(), *old)) return false;
  content(sink_of(draft.file(), path));
  if (!draft.has_moved()) refuse_path(path);
  return true;
}

/// The text is whole, and its room is there, before a byte of the old content is lost.
void write_in_place(const std::string& path, const Content& content) {
  Descriptor file(open_to_write(path, O_CREAT));
  if (!file.is_open()) refuse_path(path);
  std::string text;
  content([&](std::string_view piece) {
    if (is_writing_interrupted()) {
      throw std::invalid_argument("interrupted: " + path + " was not written");
    }
    text += piece;
  });
  const auto size = static_cast<off_t>(text.size());
  struct stat old = {};
  if (::fstat(file.number(), &old) != 0) refuse_path(path);
  const int refusal = reserve_room(file.number(), size);
  if (refusal != 0 && refusal != EOPNOTSUPP && refusal != EINVAL) {
    if (::ftruncate(file.number(), old.st_size) != 0) errno = refusal;
    errno = refusal;
    refuse_path(path);
  }
  if (!has_written_all(file.number(), text) || ::ftruncate(file.number(), size) != 0 ||
      !has_synced(file.number()) || !has_closed(file)) {
    refuse_path(path);
  }
}

/// Refuses a path at which no new file can be made. The path itself stays untouched: another
/// process may be moving its own file there.
void require_room_for(const std::string& path) {
  const std::string target = behind_links(path);
  errno = EISDIR;
  if (target.ends_with('/')) refuse_path(path);
  const Draft draft(target);
  if (!draft.file().is_open()) refuse_path(path);
}

/// Why it was not written; empty where it was.
std::string failure_of(const std::function<void()>& write) {
  try {
    write();
  } catch (const std::invalid_argument& failure) {
    return failure.what();
  } catch (const std::bad_alloc&) {
    return "there was not enough memory to write a result";
  }
  return "";
}

std::string both_failures(const std::string& failures, const std::string& failure) {
  if (failures.empty() || failure.empty()) return failures + failure;
  return failures + "\nmoivre: " + failure;
}

/// In the order of the writes, which are begun in that order.
std::string failures_of(const std::vector<std::function<void()>>& writes, int threads) {
  std::vector<std::string> failures(writes.size());
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t k = next++; k < writes.size(); k = next++) failures[k] = failure_of(writes[k]);
  };
  const std::size_t wanted =
      threads == 0 ? std::thread::hardware_concurrency() : static_cast<std::size_t>(threads);
  std::vector<std::future<void>> others;
  try {
    for (std::size_t k = 1; k < std::min(wanted, writes.size()); ++k) {
      others.push_back(std::async(std::launch::async, work));
    }
  } catch (const std::system_error&) {
    // There is no other thread to be had: this one writes what is left.
  }
  work();
  for (std::future<void>& other : others) other.get();
  return std::accumulate(failures.begin(), failures.end(), std::string(), both_failures);
}

}  // namespace

Output::Output(const std::string& path) : path_(path) {
  if (!is_wanted() || is_stdout() || !process_role().tells) return;
  const auto old = status_of(path);
  if (!old) {
    if (errno != ENOENT) refuse_path(path);
    require_room_for(path);
    return;
  }
  Descriptor file(open_to_write(path, 0));
  if (!file.is_open()) refuse_path(path);
  if (!S_ISREG(old->st_mode)) device_ = file.release();
}

Output::~Output() {
  if (device_ >= 0) ::close(device_);
}

void Output::write(const Content& content) {
  if (!process_role().tells) return;
  if (is_stdout()) return content(write_to_stdout);
  if (device_ < 0) {
    if (!is_replaced(path_, content)) write_in_place(path_, content);
    return;
  }
  Descriptor device(std::exchange(device_, -1));
  content(sink_of(device, path_));
  if (!has_closed(device)) refuse_path(path_);
}

void Output::write(std::string_view text) {
  write([text](const TextSink& sink) { sink(text); });
}

void deliver(const std::vector<Form>& forms, bool quiet, const std::function<std::string()>& text,
             const std::string& unfinished) {
  deliver(
      forms, quiet, [&text](const TextSink& sink) { sink(text()); }, unfinished);
}

void deliver(const std::vector<Form>& forms, bool quiet, const Content& text,
             const std::string& unfinished, int threads) {
  if (!process_role().tells) return;
  const Writing writing;
  std::vector<std::function<void()>> writes;
  const Form* to_stdout = nullptr;
  for (const Form& form : forms) {
    if (form.output->is_stdout()) to_stdout = &form;
    if (!form.output->is_wanted() || form.output->is_stdout()) continue;
    writes.emplace_back([&form] { form.output->write(form.content); });
  }
  const auto write_text = [&text] { text(write_to_stdout); };
  const bool is_told = to_stdout == nullptr && !quiet;
  if (to_stdout != nullptr) {
    writes.emplace_back([to_stdout] { to_stdout->output->write(to_stdout->content); });
  } else if (is_told) {
    writes.emplace_back(write_text);
  }
  std::string failures = failures_of(writes, threads);
  if (to_stdout != nullptr && !quiet && !unfinished.empty()) {
    std::fprintf(stderr, "moivre: %s\n", unfinished.c_str());
  }
  if (to_stdout == nullptr && !is_told && !failures.empty()) {
    failures = both_failures(failures, failure_of(write_text));
  }
  if (!failures.empty()) throw std::invalid_argument(failures);
}

void write_to_stdout(std::string_view text) {
  if (is_writing_interrupted()) throw std::invalid_argument("interrupted while writing");
  if (!has_written_all(STDOUT_FILENO, text)) refuse_path("standard output");
}

namespace {

/// Whether both paths lead to one file, there already or not.
bool is_same_place(const std::string& a, const std::string& b) {
  if (a == b) return true;
  if (a == "-" || b == "-") return false;
  std::error_code ignored;
  const bool is_file = std::filesystem::is_regular_file(a, ignored);
  if (is_file) return std::filesystem::equivalent(a, b, ignored);
  return std::filesystem::weakly_canonical(std::filesystem::absolute(a), ignored) ==
             std::filesystem::weakly_canonical(std::filesystem::absolute(b), ignored) &&
         !std::filesystem::exists(a, ignored);
}

}  // namespace

void require_ending(const std::string& path, const std::string& ending) {
  static const std::set<std::string> kOthers{".png",  ".jpg",  ".jpeg", ".gif", ".bmp",  ".webp",
                                             ".tif",  ".tiff", ".pdf",  ".eps", ".ps",   ".dxf",
                                             ".html", ".htm",  ".svg",  ".csv", ".json", ".xlsx"};
  const std::size_t dot = path.find_last_of("./");
  if (dot == std::string::npos || path[dot] == '/') return;
  std::string given = path.substr(dot);
  std::transform(given.begin(), given.end(), given.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const bool is_alike = given == ending || (ending == ".html" && given == ".htm");
  if (is_alike || kOthers.count(given) == 0) return;
  throw std::invalid_argument("--" + ending.substr(1) + " writes " + ending.substr(1) + ", not " +
                              given.substr(1) + ": " + path.substr(0, dot) + ending +
                              " would be its name");
}

void require_distinct(const std::vector<std::string>& outputs, const std::string& input) {
  std::error_code ignored;
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    if (outputs[i].empty()) continue;
    for (std::size_t j = 0; j < i; ++j) {
      if (outputs[j].empty() || !is_same_place(outputs[i], outputs[j])) continue;
      throw std::invalid_argument(outputs[i] == "-" ? "only one result can go to standard output"
                                                    : "two results would go to " + outputs[i]);
    }
    if (outputs[i] != "-" && std::filesystem::is_regular_file(input, ignored) &&
        std::filesystem::equivalent(outputs[i], input, ignored)) {
      throw std::invalid_argument("the result would overwrite the problem file " + input);
    }
  }
}

FolderLock::FolderLock(const std::string& path)
    : folder_(::open(folder_of(behind_links(path)).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (folder_ >= 0) ::flock(folder_, LOCK_EX);
}

FolderLock::~FolderLock() {
  if (folder_ >= 0) ::close(folder_);
}

}  // namespace moivre
