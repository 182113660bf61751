// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
//
// Loads a plugin at run time and calls it. usage: load_plugin FILE
#include <dlfcn.h>

#include <cmath>
#include <cstdio>

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  void* plugin = dlopen(argv[1], RTLD_NOW);
  if (plugin == nullptr) {
    std::fprintf(stderr, "%s\n", dlerror());
    return 1;
  }
  using Length = double (*)(double, double, double);
  const auto length = reinterpret_cast<Length>(dlsym(plugin, "shortest_length"));
  return length != nullptr && std::abs(length(12, 0, 0) - 12) < 1e-12 ? 0 : 1;
}
