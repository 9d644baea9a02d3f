// SPDX-License-Identifier: MIT
// Which paths belong together? Groups of their numbers, in two lists: nearly all of a million
// groups have one path.
//
// Private to the module.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <vector>

namespace moivre {

/// Over what a container gives by number.
template <class Container, class Value>
class ByNumber {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = Value;
  using difference_type = std::ptrdiff_t;
  using pointer = void;
  using reference = Value;

  ByNumber(const Container& container, std::size_t at) : container_(&container), at_(at) {}
  Value operator*() const { return (*container_)[at_]; }
  ByNumber& operator++() {
    ++at_;
    return *this;
  }
  friend bool operator==(const ByNumber&, const ByNumber&) = default;

 private:
  const Container* container_;
  std::size_t at_;
};

/// Paths, each group as the one who made it has ordered it; groups in the order they were added.
class PathGroups {
 public:
  using Group = std::span<const std::uint64_t>;
  using Iterator = ByNumber<PathGroups, Group>;

  std::size_t size() const { return ends_.size(); }
  bool empty() const { return ends_.empty(); }
  Group operator[](std::size_t k) const {
    const std::size_t begin = k == 0 ? 0 : ends_[k - 1];
    return Group(paths_).subspan(begin, ends_[k] - begin);
  }
  Iterator begin() const { return {*this, 0}; }
  Iterator end() const { return {*this, size()}; }

  void add(Group group) {
    paths_.insert(paths_.end(), group.begin(), group.end());
    ends_.push_back(paths_.size());
  }
  void add(std::uint64_t path) { add(Group(&path, 1)); }
  void add(const PathGroups& others) {
    for (const Group group : others) add(group);
  }
  void reserve(std::size_t groups, std::size_t paths) {
    ends_.reserve(groups);
    paths_.reserve(paths);
  }
  std::size_t path_count() const { return paths_.size(); }

 private:
  std::vector<std::uint64_t> paths_;
  std::vector<std::size_t> ends_;  ///< of each group, in paths_
};

}  // namespace moivre
