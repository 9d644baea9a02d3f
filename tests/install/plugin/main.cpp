// SPDX-License-Identifier: MIT
// A stranger's program: loads the plugin, and returns 0 when that finds all roots.
#include <dlfcn.h>

#include <cstdio>

int main() {
  void* const plugin = dlopen(PLUGIN, RTLD_NOW | RTLD_LOCAL);
  if (plugin == nullptr) {
    std::puts(dlerror());
    return 1;
  }
  const auto certified_roots = reinterpret_cast<int (*)()>(dlsym(plugin, "certified_roots"));
  return certified_roots() == 15 ? 0 : 1;
}
