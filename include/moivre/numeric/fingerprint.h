// SPDX-License-Identifier: MIT
// Is this the same as that? 128 bits that tell everything that was put in apart, but for chance.
//
// Not supported: protection against one who looks for two things with one fingerprint.
#pragma once

#include <bit>
#include <compare>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "moivre/numeric/complex.h"
#include "moivre/numeric/random.h"

namespace moivre {

struct Fingerprint {
  std::uint64_t first = 0, second = 0;
  auto operator<=>(const Fingerprint&) const = default;
};

class FingerprintMaker {
 public:
  void add(std::uint64_t word) {
    first_ = detail::mix(first_ + detail::kGoldenGamma + word);
    second_ = detail::mix((second_ ^ word) * kOdd + first_);
  }
  void add(double x) { add(std::bit_cast<std::uint64_t>(x)); }
  void add(const Complex& z) {
    add(z.real());
    add(z.imag());
  }
  void add(const Point& x) {
    add(std::uint64_t{x.size()});
    for (const Complex& xj : x) add(xj);
  }
  void add(std::string_view bytes) {
    add(std::uint64_t{bytes.size()});
    for (; !bytes.empty(); bytes.remove_prefix(std::min(bytes.size(), sizeof(std::uint64_t)))) {
      std::uint64_t word = 0;
      std::memcpy(&word, bytes.data(), std::min(bytes.size(), sizeof word));
      add(word);
    }
  }

  Fingerprint fingerprint() const { return {first_, second_}; }

 private:
  static constexpr std::uint64_t kOdd = 0xD6E8FEB86659FD93;
  std::uint64_t first_ = 1, second_ = 2;
};

/// Of these bytes.
inline Fingerprint fingerprint_of(std::string_view bytes) {
  FingerprintMaker maker;
  maker.add(bytes);
  return maker.fingerprint();
}

}  // namespace moivre
