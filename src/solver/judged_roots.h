// SPDX-License-Identifier: MIT
// On what does each root that stands rest? Groups of paths, each with its ground.
//
// Private to the module.
#pragma once

#include <cstdint>
#include <vector>

#include "path_groups.h"

namespace moivre {

/// What is known of the place at which paths end.
enum class Ground : std::uint8_t {
  proved,        ///< exactly one root lies there, a simple one
  exact,         ///< it is a multiple root, known exactly, and as many paths end there
  whole_cycles,  ///< of paths end there: as many roots lie within a ball
  on_set         ///< of positive dimension: it is no isolated root
};

struct JudgedRoot {
  PathGroups::Group paths;
  Ground ground;
};

/// As PathGroups, with grounds: a byte more for each group.
class JudgedRoots {
 public:
  using Iterator = ByNumber<JudgedRoots, JudgedRoot>;

  std::size_t size() const { return grounds_.size(); }
  bool empty() const { return grounds_.empty(); }
  std::size_t path_count() const { return groups_.path_count(); }
  JudgedRoot operator[](std::size_t k) const { return {groups_[k], grounds_[k]}; }
  Iterator begin() const { return {*this, 0}; }
  Iterator end() const { return {*this, size()}; }

  void add(PathGroups::Group paths, Ground ground) {
    groups_.add(paths);
    grounds_.push_back(ground);
  }
  void add(std::uint64_t path, Ground ground) { add(PathGroups::Group(&path, 1), ground); }
  void reserve(std::size_t groups, std::size_t paths) {
    groups_.reserve(groups, paths);
    grounds_.reserve(groups);
  }

 private:
  PathGroups groups_;
  std::vector<Ground> grounds_;
};

}  // namespace moivre
