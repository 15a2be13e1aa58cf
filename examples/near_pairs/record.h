// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// A record of a table, as text, and its fields. Fields may be quoted; then separators, line ends
// and doubled quotes inside them are text.

#ifndef NEAR_PAIRS_RECORD_H
#define NEAR_PAIRS_RECORD_H

#include <string>
#include <vector>

namespace near_pairs {

// The separator that stands for any number of blanks and tabs.
constexpr char blanks = ' ';

// The one of the candidates that a record has most of outside quotes; blanks if it has none.
char found_separator(const std::string& record, const std::string& candidates);

// Whether a quoted field of a record goes on behind this line of it.
bool has_odd_quotes(const std::string& line);

// Cuts a record into its fields; returns false if a quoted field does not end at a separator.
bool split_record(const std::string& record, char separator, std::vector<std::string>& fields);

} // namespace near_pairs

#endif // NEAR_PAIRS_RECORD_H
