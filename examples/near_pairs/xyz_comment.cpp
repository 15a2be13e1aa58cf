// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Comments of extended XYZ; see xyz_comment.h. The grammar is that of the specification at
// github.com/libAtoms/extxyz. Besides, and as the programs of the field do, this takes words
// without a value, names of keys in any case, strings in single quotes, and commas in words.

#include "xyz_comment.h"

#include "decimal.h"
#include "error.h"
#include "row_reader.h"
#include "text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <string_view>
#include <utility>

namespace near_pairs {
namespace {

const char* const blank_letters = " \t";

class Comment_parser
{
public:
  explicit Comment_parser(const std::string& text)
    : text_(text)
  {}

  Xyz_comment parse()
  {
    for(skip_blanks(); at_ < text_.size(); skip_blanks()) {
      const std::size_t begin = at_;
      const std::string key = lower_case(word());
      skip_blanks();
      if(!is_at("="))
        continue;
      ++at_;
      skip_blanks();
      std::string value = is_at("[{") ? list() : word();
      std::optional<std::string>* const wanted = value_of(key);
      if(wanted && *wanted)
        fail(begin, key + " is there twice");
      if(wanted)
        *wanted = std::move(value);
    }
    return comment_;
  }

private:
  [[noreturn]] static void fail(std::size_t at, const std::string& what)
  {
    throw Error("column " + std::to_string(at + 1) + ": " + what);
  }

  bool is_at(const char* letters) const
  {
    return at_ < text_.size() && std::string_view(letters).find(text_[at_]) != std::string::npos;
  }

  void skip_blanks() { at_ = std::min(text_.find_first_not_of(blank_letters, at_), text_.size()); }

  std::optional<std::string>* value_of(const std::string& key)
  {
    return key == "properties" ? &comment_.properties
           : key == "lattice" ? &comment_.lattice
           : key == "pbc" ? &comment_.pbc : nullptr;
  }

  // A key or a value, up to a blank or an equals sign.
  std::string word()
  {
    const std::size_t begin = at_;
    std::string result;
    if(is_at("\"'"))
      result = quoted();
    else
      while(at_ < text_.size() && !is_at(" \t=\"{}[]")) {
        at_ += text_[at_] == '\\' && at_ + 1 < text_.size();
        result += text_[at_++];
      }
    if(at_ == begin)
      fail(at_, "a key or a value is missing");
    end_word();
    return result;
  }

  void end_word() const
  {
    if(at_ < text_.size() && !is_at(" \t="))
      fail(at_, std::string("'") + text_[at_] + "' where a blank or '=' should be");
  }

  // A backslash stands before a letter that is taken as it is; \n is the end of a line.
  std::string quoted()
  {
    const std::size_t begin = at_++;
    std::string result;
    for(; at_ < text_.size() && text_[at_] != text_[begin]; ++at_) {
      const bool is_escaped = text_[at_] == '\\' && at_ + 1 < text_.size();
      at_ += is_escaped;
      result += is_escaped && text_[at_] == 'n' ? '\n' : text_[at_];
    }
    if(at_ == text_.size())
      fail(begin, "the quote is not closed");
    ++at_;
    return result;
  }

  // What is in brackets, with them.
  std::string list()
  {
    const std::size_t begin = at_;
    std::string open; // the brackets that are to be closed, the innermost one last
    do {
      if(at_ == text_.size())
        fail(begin, "the bracket is not closed");
      if(is_at("\"")) {
        quoted();
        continue;
      }
      if(is_at("[{"))
        open += is_at("[") ? ']' : '}';
      else if(is_at("]}") && text_[at_] != open.back())
        fail(at_, std::string("'") + text_[at_] + "' closes another bracket");
      else if(is_at("]}"))
        open.pop_back();
      at_ += is_at("\\") && at_ + 1 < text_.size() ? 2 : 1;
    } while(!open.empty());
    end_word();
    return text_.substr(begin, at_ - begin);
  }

  const std::string& text_;
  std::size_t at_ = 0;
  Xyz_comment comment_;
};

// Whether a key stands in a text in lower case, perhaps in quotes, and an equals sign behind it.
bool names_key(const std::string& text, const std::string& key)
{
  for(std::size_t at = text.find(key); at != std::string::npos; at = text.find(key, at)) {
    const bool begins = at == 0 || !std::isalnum(static_cast<unsigned char>(text[at - 1]));
    at += key.size();
    const bool is_quoted = at < text.size() && (text[at] == '"' || text[at] == '\'');
    const std::size_t behind = text.find_first_not_of(blank_letters, at + is_quoted);
    if(begins && behind != std::string::npos && text[behind] == '=')
      return true;
  }
  return false;
}

// Takes the brackets off a list.
std::string_view inside(std::string_view list)
{
  const char close = list.front() == '[' ? ']' : '}';
  if(list.back() != close)
    throw Error("the list does not end with its bracket");
  return trimmed(list.substr(1, list.size() - 2));
}

// The words of a list without brackets.
std::vector<std::string> row_of(std::string_view list)
{
  std::vector<std::string> row;
  for(std::size_t begin = 0; begin <= list.size(); ) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    const std::vector<std::string> between
      = words(std::string(list.substr(begin, end - begin)), list.size());
    if(between.empty())
      throw Error("a part of the list is empty");
    row.insert(row.end(), between.begin(), between.end());
    begin = end + 1;
  }
  return row;
}

} // namespace

Xyz_comment parse_comment(const std::string& text)
{
  try {
    return Comment_parser(text).parse();
  }
  catch(const Error&) {
    const std::string lower = lower_case(text);
    for(const char* key : {"properties", "lattice", "pbc"})
      if(names_key(lower, key))
        throw;
    return {};
  }
}

std::vector<std::vector<std::string>> rows_of(const std::string& value)
{
  const char* const brackets = "[]{}";
  std::string_view list = trimmed(value);
  const auto begins_list = [&] { return !list.empty() && (list[0] == '[' || list[0] == '{'); };
  if(begins_list())
    list = inside(list);
  std::vector<std::vector<std::string>> rows;
  while(begins_list()) {
    const std::size_t end = std::min(list.find_first_of(brackets, 1), list.size() - 1);
    rows.push_back(row_of(inside(list.substr(0, end + 1))));
    if(rows.back().size() != rows.front().size())
      throw Error("the lists inside the list have different lengths");
    list = trimmed(list.substr(end + 1));
    if(list.empty())
      return rows;
    if(list.front() != ',')
      throw Error("no comma is between two lists");
    list = trimmed(list.substr(1));
  }
  if(!rows.empty() || list.find_first_of(brackets) != std::string_view::npos)
    throw Error("the brackets of the list do not match");
  return {row_of(list)};
}

} // namespace near_pairs
