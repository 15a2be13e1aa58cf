#!/usr/bin/env bash
# Compiles calls with mistakes, and checks that the compiler says the sentences that stand above the
# calls, each once, and no other error.
#
#   check_mistakes.sh <source file> <command of g++>...
#
# SPDX-License-Identifier: LGPL-3.0-or-later
set -euo pipefail
export LC_ALL=C

source=$1
shift
output=$("$@" -fsyntax-only "$source" 2>&1) && { echo "The mistakes compile." >&2; exit 1; }
expected=$(awk '/^ +\/\/ / { sub(/^ +\/\/ /, ""); text = text (text == "" ? "" : " ") $0; next }
                text != "" { print text; text = "" }' "$source" |
             sed 's/^error: /&static assertion failed: /' | sort)
found=$(sed -nE 's|^[^ ]*:[0-9]+:[0-9]+: (error: .*)|\1|p' <<< "$output" | sort)

# Each mistake is reported with a few lines that say where it is.
lines=$(wc -l <<< "$output")
mistakes=$(wc -l <<< "$expected")
echo "$mistakes mistakes, $lines lines"
diff <(echo "$expected") <(echo "$found") && (( lines <= 12 * mistakes ))
