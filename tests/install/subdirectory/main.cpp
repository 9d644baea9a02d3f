// SPDX-License-Identifier: MIT
// A stranger's program: returns 0 when 31/10 rounds to the double that the compiler reads as 3.1.
#include <moivre/numeric/rational.h>

int main() { return moivre::to_double(moivre::Rational(31, 10)) == 3.1 ? 0 : 1; }
