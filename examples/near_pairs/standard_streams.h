// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What the program owes to whoever started it: nothing that it prints is lost without a word.

#ifndef NEAR_PAIRS_STANDARD_STREAMS_H
#define NEAR_PAIRS_STANDARD_STREAMS_H

#include <ostream>
#include <string>

namespace near_pairs {

// Keeps the places of standard streams that are closed, so that no file that is opened later gets
// what is meant for them. To write to them fails, as before.
void keep_closed_streams_closed();

// Lets an interrupted search end by an error, so that no temporary file stays, and a search whose
// reader has gone away as well. If the program has not ended a second later, whatever it does, or
// if it is interrupted again, it ends at once. No temporary file stays then, either.
void catch_signals();

// Throws Error if something could not be written.
void finish(std::ostream& stream, const std::string& what);

// Prints the message as a line and returns the exit status. If a pipe is broken, the program ends
// here like other programs: by the signal, quietly.
int end_with_error(const std::string& message);

} // namespace near_pairs

#endif // NEAR_PAIRS_STANDARD_STREAMS_H
