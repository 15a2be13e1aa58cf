// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The names of temporary files, for a program that has to end at once.

#ifndef NEAR_PAIRS_TEMPORARY_FILES_H
#define NEAR_PAIRS_TEMPORARY_FILES_H

#include <string>

namespace near_pairs {

// Remembers the name of a file that is to go if the program ends at once, until it is forgotten.
void remember_temporary_file(const std::string& name);
void forget_temporary_file(const std::string& name);

// Removes these files. A signal handler may call this.
void remove_temporary_files();

} // namespace near_pairs

#endif // NEAR_PAIRS_TEMPORARY_FILES_H
