// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Names of temporary files; see temporary_files.h. A signal handler may come between any two steps,
// and may neither allocate nor lock. So the names are in places of a fixed size.

#include "temporary_files.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <cstddef>

namespace near_pairs {
namespace {

struct File_name
{
  std::array<char, 4096> text = {}; // ends with a zero; longer names are names of no file
  std::atomic<bool> is_used = false; // set after the text
};

std::array<File_name, 8> file_names; // more than there are outputs

} // namespace

void remember_temporary_file(const std::string& name)
{
  for(File_name& file : file_names)
    if(!file.is_used && name.size() < file.text.size()) {
      file.text[name.copy(file.text.data(), name.size())] = '\0';
      file.is_used = true;
      return;
    }
}

void forget_temporary_file(const std::string& name)
{
  for(File_name& file : file_names)
    if(file.is_used && name == file.text.data())
      file.is_used = false;
}

void remove_temporary_files()
{
  for(const File_name& file : file_names)
    if(file.is_used)
      unlink(file.text.data());
}

} // namespace near_pairs
