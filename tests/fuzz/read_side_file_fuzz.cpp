// SPDX-License-Identifier: MIT
// Does any text break the laws of the reader of side files, which close a robot's loops? A
// libFuzzer target.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "urdf_laws.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const moivre::Robot robot =
      moivre::read_urdf(moivre::read_source(MOIVRE_SOURCE_DIR "/problems/robots/delta.urdf"));
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  const auto broken = moivre::broken_side_file_law(robot, bytes);
  if (!broken) return 0;
  std::fprintf(stderr, "%s\n", broken->c_str());
  std::abort();
}
