// SPDX-License-Identifier: MIT
// How is Arb called? arb().acb_add(...) for acb_add(...): its functions are loaded, with the library, at the first call.
//
// Double decides nearly every root, and to load Arb, FLINT and what these stand on takes as long as to solve a small
// system. Nothing is linked with them. Arb's types and macros are its headers'; its inline functions are not used, but
// those that the library holds under the same names.
// Not supported: FLINT 3, which took Arb in. Source: [Johansson17].
#pragma once

#include <acb.h>
#include <acb_mat.h>
#include <flint/flint.h>
#include <flint/fmpz.h>

// clang-format off
#define MOIVRE_ARB_FUNCTIONS(USE)                                                         \
  USE(acb_add) USE(acb_add_error_mag) USE(acb_clear) USE(arb_get_rad_arb)                 \
  USE(acb_get_mag) USE(acb_get_mid) USE(acb_init) USE(acb_mat_approx_inv)                 \
  USE(acb_mat_approx_solve)                                                               \
  USE(acb_mat_clear) USE(acb_mat_init) USE(acb_mat_mul) USE(acb_mat_zero)                 \
  USE(acb_mul) USE(acb_set) USE(acb_set_d) USE(acb_sub) USE(acb_sub_si) USE(acb_swap)     \
  USE(acb_zero) USE(arb_add_arf) USE(arb_add_error_mag) USE(arb_fmpz_div_fmpz)            \
  USE(arf_clear) USE(arf_get_d) USE(arf_init_set_ui) USE(arf_set_d)                       \
  USE(flint_cleanup) USE(fmpz_clear) USE(fmpz_init) USE(fmpz_neg)                         \
  USE(fmpz_set_ui_array) USE(mag_addmul) USE(mag_clear) USE(mag_get_d) USE(mag_init)      \
  USE(mag_is_zero) USE(mag_set_d)
// clang-format on

namespace moivre {

/// Pointers to Arb's and FLINT's functions, by their names.
struct ArbFunctions {
#define MOIVRE_DECLARE(name) decltype(&::name) name;
  MOIVRE_ARB_FUNCTIONS(MOIVRE_DECLARE)
#undef MOIVRE_DECLARE
};

/// \throws std::runtime_error  the library is not installed any more, or lacks a function
const ArbFunctions& arb();

}  // namespace moivre
