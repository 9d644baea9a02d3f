// SPDX-License-Identifier: MIT
// A stranger's program: reads a circle and a line, and returns 0 when their total degree is 2.
#include <moivre/polynomial/read.h>
#include <moivre/polynomial/system.h>

int main() {
  const moivre::Source source{"circle and line", "2\nx^2 + y^2 - 1;\nx - 3.1*y;\n"};
  const moivre::System system = moivre::read_system(source);
  return moivre::total_degree(moivre::degrees(system)) == 2 ? 0 : 1;
}
