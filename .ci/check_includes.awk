# Finds what the internal headers do not include although they use it: reads all headers twice, first
# for the names that each of them defines in the namespace, then for the names that each of them uses.
# Prints "header: name is of <wing>/<header>" for each that is missing.
#
# Names are found by the layout of the code: what is defined in a namespace begins in column 1. A
# name that a header declares for itself, such as a member function, is its own.
#
# SPDX-License-Identifier: LGPL-3.0-or-later

function bare(line) {  # without comments and strings
  gsub(/"([^"\\]|\\.)*"/, "\"\"", line)
  sub(/\/\/.*/, "", line)
  return line
}

function is_vague(name) {  # also the name of something else
  return name ~ /^(swap|get|report)$/
}

FNR == 1 { is_second = seen[FILENAME]++ }

/^ *\/\*!/ { is_in_text = 1 }
is_in_text {
  if(/\*\//)
    is_in_text = 0
  next
}

# A specialization does not define the name.
!is_second && /^(class|struct|enum class) [A-Za-z_0-9]+/ && !/;$/ && !/^(class|struct) [^ ]+</ {
  name = $0
  sub(/^(class|struct|enum class) /, "", name)
  sub(/[^A-Za-z_0-9].*/, "", name)
  type_of[name] = type_of[name] == "" ? FILENAME : type_of[name]
}
!is_second && /^using [A-Za-z_0-9]+ =/ { if(type_of[$2] == "") type_of[$2] = FILENAME }
!is_second && /^inline constexpr [A-Za-z_:]+ [A-Za-z_0-9]+( |$|;)/ {
  name = $4
  sub(/;$/, "", name)
  type_of[name] = FILENAME
}
!is_second && /^constexpr bool [a-z_]+$/ { type_of[$3] = FILENAME }
!is_second && /^[A-Za-z_][A-Za-z_0-9:<>,&* ]* [a-z_0-9]+\(/ && !/^(using|return|class|struct|#)/ {
  name = $0
  sub(/\(.*/, "", name)
  sub(/.*[ &*]/, "", name)
  if(function_of[name] == "")
    function_of[name] = FILENAME
}

is_second {
  line = bare($0)
  if(line ~ /^ *# *include/) {
    header = $2
    gsub(/[<>"]/, "", header)
    includes[FILENAME, header] = 1
    next
  }
  if(line ~ /^ +using [A-Za-z_0-9]+ =/ || line ~ /^ *class [A-Za-z_0-9]+;/) {
    split(line, word, /[ ;]+/)
    own[FILENAME, word[line ~ /^ /? 3 : 2]] = 1
  }
  rest = line
  while(match(rest, /[A-Za-z_][A-Za-z_0-9]*/)) {
    name = substr(rest, RSTART, RLENGTH)
    before = substr(rest, 1, RSTART - 1)
    rest = substr(rest, RSTART + RLENGTH)
    if(name in type_of && before !~ /(class|typename|struct) $/ && before !~ /(\.|->)$/)
      uses[FILENAME, name] = type_of[name]
    else if(name in function_of && rest ~ /^(<[^;]*>)?\(/ && before !~ /(\.|->|std::|::template |CGAL::)$/) {
      if(before ~ /[A-Za-z_0-9>&*] +[*&]?$/ && before !~ /(return|else|case) +$/)
        own[FILENAME, name] = 1
      else
        uses[FILENAME, name] = function_of[name]
    }
  }
}

END {
  for(key in uses) {
    split(key, part, SUBSEP)
    file = part[1]; name = part[2]; header = uses[key]
    if(header != file && !((file, header) in includes) && !((file, name) in own) && !is_vague(name))
      print file ": " name " is of <" header ">"
  }
}
