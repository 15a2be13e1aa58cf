# Finds what the internal headers do not include although they use it: reads all headers twice, first
# for the names that each of them defines in the namespace, then for the names that each of them uses.
# Prints "header: name is of <room>/<header>" for each that is missing. The same for names of the
# standard library that one header has, and that other standard headers may include or not.
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

# Whether a file includes or is one of those that overload a function.
function has_overload(file, name,    list, i) {
  split(overloads[name], list, " ")
  for(i in list)
    if(list[i] == file || (file, list[i]) in includes)
      return 1
  return 0
}

function is_vague(name) {  # also the name of something else
  return name ~ /^(swap|get|report|alignas)$/
}

function standard(header, names,    list, i) {
  split(names, list, " ")
  for(i in list)
    standard_header_of[list[i]] = header
}

BEGIN {
  standard("algorithm", "min max minmax clamp sort stable_sort copy copy_n copy_if fill fill_n find " \
    "find_if count count_if for_each transform merge unique reverse partition stable_partition " \
    "partition_point nth_element lower_bound upper_bound equal_range binary_search all_of any_of " \
    "none_of max_element min_element minmax_element is_sorted remove_if")
  standard("array", "array")
  standard("atomic", "atomic memory_order_relaxed memory_order_acquire memory_order_release")
  standard("cmath", "fabs sqrt floor ceil ldexp ilogb isfinite isnan isinf isnormal signbit pow " \
    "log2 nextafter nearbyint lround fma expm1 frexp")
  standard("cstddef", "size_t ptrdiff_t")
  standard("cstdint", "int32_t int64_t uint16_t uint32_t uint64_t uintptr_t")
  standard("cstring", "memcpy strlen")
  standard("deque", "deque")
  standard("exception", "exception exception_ptr current_exception rethrow_exception")
  standard("functional", "function less minus plus reference_wrapper")
  standard("iterator", "iterator_traits back_inserter random_access_iterator_tag input_iterator_tag")
  standard("limits", "numeric_limits")
  standard("memory", "unique_ptr make_unique shared_ptr make_shared addressof")
  standard("mutex", "mutex lock_guard unique_lock")
  standard("numeric", "iota accumulate partial_sum")
  standard("optional", "optional nullopt")
  standard("set", "set")
  standard("sstream", "ostringstream istringstream stringstream")
  standard("stdexcept", "invalid_argument length_error runtime_error logic_error")
  standard("string", "string to_string")
  standard("tuple", "tuple tie tuple_element_t tuple_cat apply")
  standard("type_traits", "decay_t is_same_v void_t integral_constant conditional_t false_type " \
    "true_type enable_if_t bool_constant is_invocable_v is_void_v is_arithmetic_v " \
    "invoke_result_t remove_reference_t is_lvalue_reference_v is_reference_v is_integral_v " \
    "is_convertible_v is_constructible_v remove_const_t add_const_t is_same is_floating_point " \
    "is_copy_constructible is_class_v is_base_of_v disjunction")
  standard("utility", "pair make_pair move forward declval swap exchange index_sequence " \
    "make_index_sequence in_place_index in_place_index_t")
  standard("variant", "variant visit get_if")
  standard("vector", "vector")
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
!is_second && /^(decltype\(auto\)|[A-Za-z_][A-Za-z_0-9:<>,&* ]*) [a-z_0-9]+\(/ && !/^(using|return|class|struct|#)/ {
  name = $0
  sub(/^decltype\(auto\)/, "auto", name)
  sub(/\(.*/, "", name)
  sub(/.*[ &*]/, "", name)
  if(function_of[name] == "")
    function_of[name] = FILENAME
  overloads[name] = overloads[name] " " FILENAME
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
    is_standard = before == "::" && previous == "std"
    is_behind_type = rest != line && before ~ /^ +[*&]?$/ && previous !~ /^(return|else|case)$/
    previous = name
    if(is_standard && name in standard_header_of)
      uses[FILENAME, "std::" name] = standard_header_of[name]
    rest = substr(rest, RSTART + RLENGTH)
    if(name in type_of && before !~ /(class|typename|struct) $/ && before !~ /(\.|->)$/)
      uses[FILENAME, name] = type_of[name]
    else if(name in function_of && rest ~ /^(<[^;]*>)?\(/ && before !~ /(\.|->|std::|::template |CGAL::)$/) {
      if(is_behind_type || before ~ /[>&*] +[*&]?$/)
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
    if(header != file && !((file, header) in includes) && !((file, name) in own) \
       && !has_overload(file, name) && !is_vague(name))
      print file ": " name " is of <" header ">"
  }
}
