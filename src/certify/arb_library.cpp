// SPDX-License-Identifier: MIT
// dlopen and dlsym; the library stays loaded, since FLINT keeps memory for each thread.
#include "arb_library.h"

#include <dlfcn.h>

#include <stdexcept>
#include <string>

namespace moivre {
namespace {

[[noreturn]] void fail() {
  throw std::runtime_error(std::string("Arb, which certifies roots, cannot be loaded: ") +
                           dlerror() + "; install it, or leave certificates out");
}

template <class Function>
Function* loaded(void* library, const char* name, Function*) {
  void* const address = dlsym(library, name);
  if (address == nullptr) fail();
  return reinterpret_cast<Function*>(address);
}

ArbFunctions load() {
  void* const library = dlopen(MOIVRE_ARB_LIBRARY, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) fail();
  ArbFunctions functions{};
#define MOIVRE_LOAD(name) functions.name = loaded(library, #name, functions.name);
  MOIVRE_ARB_FUNCTIONS(MOIVRE_LOAD)
#undef MOIVRE_LOAD
  return functions;
}

}  // namespace

const ArbFunctions& arb() {
  static const ArbFunctions functions = load();
  return functions;
}

}  // namespace moivre
