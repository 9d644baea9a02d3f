// SPDX-License-Identifier: MIT
// How are unknowns and equations of a formulation collected? Each unknown with what it is and
// whose, each equation with its name.
#pragma once

#include <string>
#include <vector>

#include "moivre/formulation/formulation.h"

namespace moivre {

class Frame {
 public:
  /// Its own mirror image; `owners` are the bodies (or unknowns) that it places. Returns its
  /// number.
  std::uint32_t add_variable(const std::string& name, bool is_direction,
                             const std::vector<std::string>& owners) {
    const std::size_t index = result_.system.variables.size();
    result_.system.variables.push_back(name);
    result_.mirror.push_back(index);
    result_.is_direction.push_back(is_direction);
    result_.owners.push_back(owners);
    return static_cast<std::uint32_t>(index);
  }

  Polynomial add_unknown(const std::string& name, bool is_direction,
                         const std::vector<std::string>& owners) {
    return unknown(add_variable(name, is_direction, owners));
  }

  Formulation& result() { return result_; }
  const Formulation& result() const { return result_; }

 protected:
  void enter(const std::string& name, Polynomial equation) {
    result_.system.polynomials.push_back(std::move(equation));
    result_.equation_names.push_back(name);
  }

 private:
  Formulation result_;
};

}  // namespace moivre
