#!/usr/bin/env bash
# Checks what holds for every source file whatever its style: no tabs, no blanks at line ends, a
# final newline, at most 100 columns, and a line that names the license. Documents have at most 100
# columns too, but for rows of tables and addresses.
# Prints each offending line; exits with 1 if there is one. (.clang-format describes the style; it
# is a help for editors and not enforced.)
#
# SPDX-License-Identifier: LGPL-3.0-or-later
set -euo pipefail
export LC_ALL=C.UTF-8

cd "$(dirname "${BASH_SOURCE[0]}")/.."

find_files() {  # find expression...
  find . -path './build*' -prune -o -path ./.git -prune -o -type f \( "$@" \) -print | sort
}
mapfile -t cpp_files < <(find_files -name '*.h' -o -name '*.inc' -o -name '*.cpp')
mapfile -t documents < <(find_files -name '*.md' -o -path './doc/*.txt')
mapfile -t other_files < <(find_files -name CMakeLists.txt -o -name '*.cmake' -o -name '*.in' \
                             -o -name '*.sh' -o -name '*.py' -o -path './scripts/*' -o -path ./.ci/run)
source_files=("${cpp_files[@]}" "${other_files[@]}")
(( ${#cpp_files[@]} > 0 )) || { echo "No C++ files found." >&2; exit 1; }

fail=0
forbid() {  # reason; the offending places on standard input
  local line
  while IFS= read -r line; do
    echo "$line    <- $1" >&2
    fail=1
  done
}

forbid 'tab' < <(grep -nP '\t' "${source_files[@]}")
forbid 'blank at the end of the line' < <(grep -nE '[[:space:]]$' "${source_files[@]}")
forbid 'more than 100 columns' < <(grep -nE '^.{101,}$' "${cpp_files[@]}")
forbid 'more than 100 columns' < <(
  grep -nE '^.{101,}$' "${documents[@]}" | grep -vE '^[^:]*:[0-9]+:([|]| *\\|.*https?://)')
forbid 'no SPDX line' < <(grep -L 'SPDX-License-Identifier: ' "${source_files[@]}")
forbid 'no newline at the end' < <(
  for file in "${source_files[@]}"; do  # no process for each of the files
    if [[ -s $file ]] && ! { mapfile -t -d '' < "$file"; [[ ${MAPFILE[-1]} == *$'\n' ]]; }; then
      echo "$file"
    fi
  done)

# Headers meet the macros min and max of Windows, and those of users: they call neither, and their own
# macros have the prefix of the package, unless the same file ends them. CGAL asks the same of tests.
mapfile -t headers < <(find_files -path './include/*.h' -o -path './include/*.inc')
mapfile -t tests < <(find_files -path './test/*.h' -o -path './test/*.cpp')
forbid 'min and max may be macros: (std::max)(a, b)' < <(
  grep -nE '(^|[^_[:alnum:]])(min|max)\(' "${headers[@]}" "${tests[@]}" | grep -vE '^[^:]*:[0-9]+: *//')
forbid 'a macro that stays has the prefix CGAL_THICK_INTERSECTION_D_, or ends with _H as a guard' < <(
  awk 'function tell() { for(macro in lines) print lines[macro]; delete lines }
       FNR == 1 { tell() }
       /^ *# *define / { macro = $0; sub(/^ *# *define +/, "", macro); sub(/[^A-Za-z_0-9].*/, "", macro)
         if(macro !~ /^CGAL_THICK_INTERSECTION_D_/ && macro !~ /^CGAL_.*_H$/)
           lines[macro] = FILENAME ":" FNR ":" $0 }
       /^ *# *undef / { delete lines[$NF] }
       END { tell() }' "${headers[@]}")

exit $fail
