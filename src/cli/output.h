// SPDX-License-Identifier: MIT
// Where do results go? Files that are known to be writable before a long run begins, or stdout; no
// result is lost for another.
//
// Nothing is touched before write(). A regular file is then written beside its place and moved
// there when it is whole and on the disk, so that an old file stays until then and no half of a new
// one is ever seen. Until then it has no name (O_TMPFILE), so that a killed run leaves nothing; on
// file systems without such files its name is .moivre-<process>-<number>. Where it cannot be moved
// there (a link's other name, a folder that cannot be written) it is written in place, when its
// room is reserved. "-" is stdout.
// A process that only works (process_role.h) writes nothing.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "moivre/report/text_sink.h"

namespace moivre {

/// A text that is written piece by piece to where it is told.
using Content = std::function<void(const TextSink&)>;

class Output {
 public:
  /// An empty path: nothing is wanted. Throws std::invalid_argument with the reason when the path
  /// cannot be written.
  explicit Output(const std::string& path);
  ~Output();
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  bool is_wanted() const { return !path_.empty(); }
  bool is_stdout() const { return path_ == "-"; }
  /// Replaces the file's content. Throws std::invalid_argument when the disk is full and the like,
  /// and what `content` throws;
  /// the old content stands then, but where it is written in place.
  void write(const Content& content);
  void write(std::string_view text);

 private:
  std::string path_;
  int device_ = -1;  ///< held open: what is no regular file (a pipe, a terminal)
};

/// Where closures and motions go in each of their forms.
struct Outputs {
  Output json, csv, svg, html;

  std::vector<Output*> in_order() { return {&json, &csv, &svg, &html}; }
};

/// One form of a result, made when it is written.
struct Form {
  Form(Output* where, Content pieces) : output(where), content(std::move(pieces)) {}
  Form(Output* where, const std::function<std::string()>& whole)
      : output(where), content([whole](const TextSink& sink) { sink(whole()); }) {}

  Output* output;
  Content content;
};

/// Writes every wanted form, files first, stdout last; then `text`, for people, to stdout, unless
/// it is `quiet` or stdout is taken. Where a file cannot be written all the others are, `text` is
/// printed in any case, and std::invalid_argument is thrown at the end. `unfinished`, a sentence or
/// empty, goes to stderr where no text tells it. On so many threads at once, 0: as many as the
/// machine has; contents must then not know of each other.
void deliver(const std::vector<Form>& forms, bool quiet, const Content& text,
             const std::string& unfinished = "", int threads = 1);
void deliver(const std::vector<Form>& forms, bool quiet, const std::function<std::string()>& text,
             const std::string& unfinished = "");

/// Alone among the processes that write to the folder of `path` by such a lock, while it lives.
class FolderLock {
 public:
  explicit FolderLock(const std::string& path);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int folder_ = -1;  ///< where it cannot be locked nothing is
};

/// All of the text to stdout. Throws std::invalid_argument when it cannot be written.
void write_to_stdout(std::string_view text);

/// Throws std::invalid_argument when the path's ending says another format than `ending`, ".svg":
/// out.png is no SVG.
void require_ending(const std::string& path, const std::string& ending);

/// Throws std::invalid_argument when two results would go to one place, or one would overwrite
/// `input`.
void require_distinct(const std::vector<std::string>& outputs, const std::string& input);

}  // namespace moivre
