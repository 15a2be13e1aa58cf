// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The format of fuzz_file.cpp, which is compiled once for all formats.

extern const char* const fuzz_format;
const char* const fuzz_format = THICK_FUZZ_FORMAT;
