// SPDX-License-Identifier: MIT
// Double after double off the midpoint.
#include "arb_polynomial.h"

namespace moivre {

SumOfDoubles sum_of_doubles(acb_srcptr ball, int bits) {
  constexpr int kBitsOfDouble = 53;
  constexpr double kUp = 1 + 0x1p-40;
  SumOfDoubles result;
  ArbBall rest;
  acb_get_mid(rest.get(), ball);
  for (int known = 0; known <= bits; known += kBitsOfDouble) {
    const Complex part(take_double(acb_realref(rest.get())), take_double(acb_imagref(rest.get())));
    if (part == Complex(0) && known > 0) break;
    result.parts.push_back(part);
  }
  ArbBall error;
  acb_sub(error.get(), ball, ball, kBitsOfDouble);  // 0 and twice the radii
  acb_add(error.get(), error.get(), rest.get(), kBitsOfDouble);
  ArbSize size;
  acb_get_mag(size.get(), error.get());
  result.error = kUp * size.upper();
  return result;
}

}  // namespace moivre
