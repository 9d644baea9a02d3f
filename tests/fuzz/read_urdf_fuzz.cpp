// SPDX-License-Identifier: MIT
// Does any text break the laws of the reader of URDF files? A libFuzzer target.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "urdf_laws.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  const auto broken = moivre::broken_urdf_law(bytes);
  if (!broken) return 0;
  std::fprintf(stderr, "%s\n", broken->c_str());
  std::abort();
}
