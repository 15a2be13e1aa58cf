// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Records of tables; see record.h.

#include "record.h"

#include "decimal.h"
#include "error.h"

#include <algorithm>
#include <string_view>

namespace near_pairs {
Records::Records(const Input& input, char separator, bool comma_numbers)
  : lines_(input), separator_(separator), comma_numbers_(comma_numbers)
{}

bool Records::next(std::vector<std::string>& fields)
{
  if(!next_text())
    return false;
  if(separator_ == 0)
    separator_ = most_used_separator();
  is_first_ = false;
  split(fields);
  return true;
}

std::vector<std::string> Records::fields_of(const std::string& text)
{
  std::vector<std::string> fields;
  record_ = text;
  begins_with_hash_ = true; // so that it has one line
  split(fields);
  return fields;
}

// Reads the first line of the next record.
bool Records::next_text()
{
  while(lines_.next(record_)) {
    const std::string_view text = trimmed(record_);
    const bool has_fields
      = !is_first_ && separator_ == '\t' && record_.find(separator_) != std::string::npos;
    begins_with_hash_ = !text.empty() && text.front() == '#';
    line_ = lines_.number();
    if(line_ == 1 && take_separator_line())
      continue;
    if(has_fields || (!text.empty() && !(is_first_ && begins_with_hash_)))
      return true;
    if(is_first_)
      comment_ = text.empty() ? text : text.substr(1);
  }
  return false;
}

// A separator that the user names comes first.
bool Records::take_separator_line()
{
  const std::string quotes = record_.substr(0, record_.compare(0, 1, "\"") == 0 ? 1 : 0);
  const std::string begin = quotes + "sep=";
  if(record_.size() != begin.size() + 1 + quotes.size() || record_.compare(0, begin.size(), begin))
    return false;
  if(separator_ == 0)
    separator_ = record_[begin.size()];
  return true;
}

// The one that the record in hand has most of outside quotes; a blank if it has none. The record
// may begin with a field of several lines.
char Records::most_used_separator()
{
  const std::string candidates = comma_numbers_ ? "\t;|" : "\t;,|";
  std::vector<std::size_t> counts(candidates.size());
  auto most = counts.begin();
  bool is_quoted = false;
  std::size_t at = 0;
  do {
    for(; at < record_.size(); ++at) {
      is_quoted ^= record_[at] == '"';
      const std::size_t candidate = is_quoted ? std::string::npos : candidates.find(record_[at]);
      if(candidate != std::string::npos)
        ++counts[candidate];
    }
    most = std::max_element(counts.begin(), counts.end());
  } while(*most == 0 && is_quoted && go_on_in_next_line());
  return *most == 0 ? ' ' : candidates[most - counts.begin()];
}

void Records::split(std::vector<std::string>& fields)
{
  fields.clear();
  std::size_t at = has_blanks_between() ? behind_blanks(0) : 0;
  while(true) {
    fields.push_back(take_field(at, fields.size() + 1));
    if(at == record_.size())
      return;
    at = has_blanks_between() ? behind_blanks(at) : at + 1;
    if(has_blanks_between() && at == record_.size())
      return;
  }
}

// Takes field `number` off the record at `at`, which is moved to its separator or the end.
std::string Records::take_field(std::size_t& at, std::size_t number)
{
  const std::size_t begin = behind_blanks(at);
  if(begin < record_.size() && record_[begin] == '"') {
    std::size_t end = begin;
    std::string field = take_quoted(end, number);
    end = has_blanks_between() ? end : behind_blanks(end);
    if(end == record_.size() || is_separator(end)) {
      at = end;
      return field;
    }
    // Programs that separate by tabs often leave quotes as they are, and write no line ends.
    if(separator_ != '\t' || record_.find('\n') != std::string::npos)
      throw Error(file(), line_, "field " + std::to_string(number) + ": a quoted field does not "
                  "end at a separator; a quote inside of it is doubled");
  }
  at = find_separator(begin);
  return std::string(trimmed(std::string_view(record_).substr(begin, at - begin)));
}

// Takes what is between the quote at `at` and the next one that is not doubled. Each line is looked
// at once, so that a stray quote costs no more than any other letter.
std::string Records::take_quoted(std::size_t& at, std::size_t number)
{
  std::string field;
  while(true) {
    const std::size_t begin = ++at;
    at = record_.find('"', begin);
    field.append(record_, begin, at == std::string::npos ? at : at - begin);
    if(at == std::string::npos) {
      at = record_.size();
      if(begins_with_hash_) // a comment has one line
        return field;
      if(!go_on_in_next_line())
        throw Error(file(), line_, "field " + std::to_string(number) + ": a quote is not closed");
      field.push_back('\n');
    }
    else if(++at == record_.size() || record_[at] != '"')
      return field;
    else
      field.push_back('"');
  }
}

bool Records::go_on_in_next_line()
{
  if(!lines_.next(more_))
    return false;
  record_.append(1, '\n').append(more_);
  return true;
}

bool Records::is_separator(std::size_t at) const
{
  return record_[at] == separator_ || (has_blanks_between() && record_[at] == '\t');
}

// A tab that separates fields is no blank.
std::size_t Records::behind_blanks(std::size_t at) const
{
  return std::min(record_.find_first_not_of(separator_ == '\t' ? " " : " \t", at), record_.size());
}

std::size_t Records::find_separator(std::size_t at) const
{
  const std::size_t place = has_blanks_between() ? record_.find_first_of(" \t", at)
                                                 : record_.find(separator_, at);
  return std::min(place, record_.size());
}

} // namespace near_pairs
