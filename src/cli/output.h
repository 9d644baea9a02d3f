// SPDX-License-Identifier: MIT
// Where do results go? Files that are known to be writable before a long run begins, or stdout.
//
// A file is opened when the Output is made, and neither cut short nor written before write(): a run that is refused
// leaves an old file as it was and no new one behind. "-" is stdout.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace moivre {

class Output {
 public:
  /// An empty path: nothing is wanted. Throws std::invalid_argument with the reason when the path cannot be written.
  explicit Output(const std::string& path);
  ~Output();
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  bool is_wanted() const { return !path_.empty(); }
  bool is_stdout() const { return path_ == "-"; }
  /// Replaces the file's content. Throws std::invalid_argument when the disk is full and the like.
  void write(std::string_view text);

 private:
  std::string path_;
  int descriptor_ = -1;
  bool is_new_ = false;
};

/// All of the text to stdout. Throws std::invalid_argument when it cannot be written.
void write_to_stdout(std::string_view text);

/// Throws std::invalid_argument when two results would go to one place, or one would overwrite `input`.
void require_distinct(const std::vector<std::string>& outputs, const std::string& input);

}  // namespace moivre
