// SPDX-License-Identifier: MIT
// How is a complex number held whose digits are beyond any machine number? Written out in decimal,
// as plain text.
#pragma once

#include <string>

namespace moivre {

/// Each part as "-1.2345e-7" or "12.345"; every digit that stands there is right; "0" where none is
/// known.
struct ComplexDecimal {
  std::string re;
  std::string im;

  friend bool operator==(const ComplexDecimal&, const ComplexDecimal&) = default;
};

}  // namespace moivre
