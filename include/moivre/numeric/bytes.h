// SPDX-License-Identifier: MIT
// How are values written as bytes, and read back to the last bit?
//
// As they stand in memory: what this program has written on this kind of machine it reads again.
// Lengths stand before what they count.
// Edges: bytes that end too soon, or too late, and a bool that is neither, throw
// std::invalid_argument.
#pragma once

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace moivre {

class ByteWriter {
 public:
  template <class T>
  void put(const T& value) {
    static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  /// Of numbers, complex ones too.
  template <class T>
  void put(const std::vector<T>& values) {
    put(static_cast<std::uint64_t>(values.size()));
    if (!values.empty()) {
      bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
    }
  }
  void put(std::string_view text) {
    put(static_cast<std::uint64_t>(text.size()));
    bytes_ += text;
  }

  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

  template <class T>
  T get() {
    static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
    if constexpr (std::is_same_v<T, bool>) {
      const auto kept = get<unsigned char>();
      if (kept > 1) refuse();
      return kept == 1;
    }
    T value;
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  }
  template <class T>
  std::vector<T> get_vector() {
    const auto count = get<std::uint64_t>();
    if (count > rest_.size() / sizeof(T)) refuse();
    std::vector<T> values(static_cast<std::size_t>(count));
    if (count > 0) {
      const std::string_view bytes = take(values.size() * sizeof(T));
      std::memcpy(static_cast<void*>(values.data()), bytes.data(), bytes.size());
    }
    return values;
  }
  std::string_view get_text() {
    const auto size = get<std::uint64_t>();
    if (size > rest_.size()) refuse();
    return take(static_cast<std::size_t>(size));
  }

  bool is_at_end() const { return rest_.empty(); }
  void require_end() const {
    if (!rest_.empty()) refuse();
  }

 private:
  [[noreturn]] static void refuse() {
    throw std::invalid_argument("kept bytes are not what was written");
  }
  std::string_view take(std::size_t size) {
    if (size > rest_.size()) refuse();
    const std::string_view taken = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return taken;
  }

  std::string_view rest_;
};

}  // namespace moivre
