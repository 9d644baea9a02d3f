// SPDX-License-Identifier: MIT
// A stranger's program: returns 0 when an expression has its one fault, and a file that is not
// there is refused by the library's exception.
#include <moivre/expression/expression.h>
#include <moivre/expression/source.h>

int main() {
  std::vector<moivre::Diagnostic> faults;
  moivre::parse_expression("x + 2*(y - 31/10", {}, faults);
  try {
    moivre::read_source("there is no such file");
  } catch (const moivre::InvalidInput&) {
    return faults.size() == 1 ? 0 : 1;
  }
  return 1;
}
