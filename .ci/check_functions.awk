# Finds functions of more than `limit` lines, from the brace that opens the body to the one that
# closes it. Bodies are found by the layout of the code: either brace stands alone in its line.
#
# SPDX-License-Identifier: LGPL-3.0-or-later

{
  match($0, /^ */)
  indent = RLENGTH
  if($0 ~ /^ *\{$/)
    begin[indent] = previous ~ /^ *(class|struct|enum|namespace)/ ? 0 : FNR
  if($0 ~ /^ *\};?$/ && begin[indent] != 0) {
    if(FNR - begin[indent] + 1 > limit)
      print FILENAME ":" begin[indent] ": " FNR - begin[indent] + 1 " lines: " previous_of[indent]
    begin[indent] = 0
  }
  if($0 ~ /^ *\{$/)
    previous_of[indent] = previous
  previous = $0
}
