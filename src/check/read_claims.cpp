// SPDX-License-Identifier: MIT
// The form of a result, recognized by its first character and by the head of a list.

#include "moivre/numeric/invalid_input.h"
#include "read_forms.h"

namespace moivre {

Claims read_claims(const Source& source, const std::vector<std::string>& variables) {
  const std::size_t begin = source.text.find_first_not_of(" \t\r\n");
  if (begin == std::string::npos) throw InvalidInput(source.name + ": the file is empty");
  const char first = source.text[begin];
  if (first == '{' || first == '[') return read_solve_json(source);
  if (source.text.find("SOLUTIONS") == std::string::npos &&
      source.text.find("solution 1 :") == std::string::npos) {
    throw InvalidInput(
        source.name +
        ": neither the JSON of moivre solve nor a solution list of PHCpack (THE SOLUTIONS)");
  }
  return read_solution_list(source, variables);
}

}  // namespace moivre
