// SPDX-License-Identifier: MIT
// Which families do closures of a mechanism use? Those of a file, which takes in what is learned.
#pragma once

#include <memory>
#include <string>

#include "moivre/family/book.h"
#include "output.h"

namespace moivre {

class MechanismFamilies {
 public:
  /// path: empty where none are wanted; a file that is not there yet is begun. Throws
  /// std::invalid_argument where it holds something else, or cannot be written.
  MechanismFamilies(const std::string& path, const std::string& source, std::uint64_t seed);

  FamilyBook& book() { return book_; }
  /// The book, where families are wanted; else nullptr.
  KnownStarts* starts();
  /// Writes the file where something was learned, or it is new, with what another process has
  /// learned meanwhile.
  void keep();

 private:
  std::string path_;
  std::string source_;
  bool is_new_ = false;
  FamilyBook book_;
  Output file_;
};

}  // namespace moivre
