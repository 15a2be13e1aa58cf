// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Takes the place of libFuzzer where the compiler has none: gives the files that are named on the
// command line to the function that libFuzzer would call. Like libFuzzer, it names each file first.

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int main(int argc, char** argv)
{
  for(int i = 1; i < argc; ++i) {
    std::cout << "Running: " << argv[i] << std::endl; // at once: the last one is to blame
    std::ifstream file(argv[i], std::ios::binary);
    const std::string bytes(std::istreambuf_iterator<char>(file), {});
    if(!file) {
      std::cout << "cannot be read" << std::endl;
      return 1;
    }
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  }
  return argc == 1 ? 1 : 0;
}
