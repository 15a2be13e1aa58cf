// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The format .tsp, and the choice of a format; see row_reader.h.

#include "row_reader.h"

#include "csv_reader.h"
#include "decimal.h"
#include "error.h"
#include "obj_reader.h"
#include "off_reader.h"
#include "pdb_reader.h"
#include "ply_reader.h"
#include "xyz_reader.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <initializer_list>

namespace near_pairs {
namespace {

// TSPLIB: a head of "KEY : value" lines, then NODE_COORD_SECTION with a node number and its
// coordinates on each line, up to EOF or the next section.
class Tsp_reader : public Row_reader
{
public:
  Tsp_reader(const Input& input, const Read_options& options)
    : lines_(input)
  {
    read_head();
    take_line();
    const std::size_t in_file = std::max<std::size_t>(words(line_, 5).size(), 1) - 1;
    dimension = in_file == 3 ? 3 : 2;
    if(options.dimension > dimension)
      throw Error(input.name(), lines_.number(), "the nodes have no third coordinate");
    words_per_node_ = 1 + dimension;
    if(options.dimension != 0)
      dimension = options.dimension;
  }

  bool next(Row& row) override
  {
    const std::vector<std::string> texts = words(line_, words_per_node_ + 1);
    if(!more_ || is_end(texts.front())) {
      check_count();
      return false;
    }
    if(texts.size() != words_per_node_)
      throw Error(lines_.file(), lines_.number(), "a node has " + plural(words_per_node_, "word")
                  + ", and this line has not");
    row.line = lines_.number();
    std::copy_n(texts.begin() + 1, dimension, row.coordinates.begin());
    ++count_;
    take_line();
    return true;
  }

private:
  // Takes the next line that is not blank.
  void take_line()
  {
    do
      more_ = lines_.next(line_);
    while(more_ && words(line_, 1).empty());
  }

  void read_head()
  {
    while(lines_.next(line_)) {
      const std::string key = line_.substr(0, line_.find(':'));
      if(trimmed(key) == "NODE_COORD_SECTION")
        return;
      if(trimmed(key) == "DIMENSION" && key.size() < line_.size())
        promised_ = std::strtoull(line_.c_str() + key.size() + 1, nullptr, 10);
    }
    throw Error(lines_.file(), "no NODE_COORD_SECTION");
  }

  static bool is_end(const std::string& word)
  {
    const std::string suffix = "_SECTION";
    return word == "EOF" || word == "-1" ||
      (word.size() > suffix.size() && word.substr(word.size() - suffix.size()) == suffix);
  }

  void check_count() const
  {
    if(promised_ != 0 && count_ != promised_)
      throw Error(lines_.file(), lines_.number(), plural(count_, "node") + " where DIMENSION says "
                  + std::to_string(promised_));
  }

  Lines lines_;
  std::string line_; // the next one, if more_
  bool more_ = false;
  std::size_t words_per_node_ = 0;
  std::size_t count_ = 0;
  std::size_t promised_ = 0; // 0: the head does not say
};

} // namespace

std::string format_of(const std::string& file, const Read_options& options)
{
  if(!options.format.empty())
    return options.format;
  if(file == "-")
    return "csv";
  std::filesystem::path name = file;
  if(extension(name.string()) == ".gz")
    name.replace_extension();
  const std::string format = extension(name.string());
  return format.substr(format.empty() ? 0 : 1);
}

namespace {

// The option of these that only tables have, or an empty text.
std::string option_for_tables(const Read_options& options)
{
  return options.geographic ? "--geographic"
         : !options.columns.empty() ? "--columns"
         : !options.id.empty() ? "--id"
         : options.no_header ? "--no-header"
         : options.comma_numbers ? "--comma-numbers"
         : options.skip_missing ? "--skip-missing"
         : options.separator != 0 ? "--separator" : "";
}

// Returns nothing if the format is unknown.
std::unique_ptr<Row_reader> reader_of(const std::string& format, const Input& input,
                                      const Read_options& options)
{
  if(format == "xyz")
    return std::make_unique<Xyz_reader>(input, options);
  if(format == "tsp")
    return std::make_unique<Tsp_reader>(input, options);
  if(format == "off")
    return std::make_unique<Off_reader>(input, options);
  if(format == "ply")
    return std::make_unique<Ply_reader>(input, options);
  if(format == "obj")
    return std::make_unique<Obj_reader>(input, options);
  if(format == "pdb" || format == "ent")
    return std::make_unique<Pdb_reader>(input, options);
  return nullptr;
}

// What to do with files that other programs read: Debian 12 has no library for LAS and LAZ.
std::string advice_on(const std::string& format)
{
  return format == "las" || format == "laz" ? " ('pdal translate' makes a .csv file of this one)"
                                            : "";
}

void refuse_options_for_tables(const Input& input, const Read_options& options)
{
  const std::string option = option_for_tables(options);
  if(!option.empty())
    throw Error(input.name(), option + " needs a table, such as a .csv file");
}

} // namespace

std::unique_ptr<Row_reader> open_rows(const Input& input, const Read_options& options)
{
  const std::string format = format_of(input.name(), options);
  if(is_table(input.name(), options))
    return std::make_unique<Csv_reader>(input, options);
  auto reader = reader_of(format, input, options);
  if(!reader)
    throw Error(input.name(), "unknown format; name one of csv (for any table), xyz, off, ply, "
                "obj, pdb, tsp, bin, wkt and geojson by --format" + advice_on(format));
  refuse_options_for_tables(input, options);
  return reader;
}

bool is_table(const std::string& file, const Read_options& options)
{
  const std::initializer_list<const char*> tables = {"csv", "tsv", "txt", "dat"};
  return std::find(tables.begin(), tables.end(), format_of(file, options)) != tables.end();
}

bool is_binary(const Input& input, const Read_options& options)
{
  if(format_of(input.name(), options) != "bin")
    return false;
  refuse_options_for_tables(input, options);
  return true;
}

std::string extension(const std::string& file)
{
  std::string format = std::filesystem::path(file).extension().string();
  for(char& letter : format)
    letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return format;
}

std::vector<std::string> words(const std::string& line, std::size_t most)
{
  const char* const blanks = " \t\r\v\f";
  std::vector<std::string> result;
  std::size_t end = 0;
  while(result.size() < most) {
    const std::size_t begin = line.find_first_not_of(blanks, end);
    if(begin == std::string::npos)
      break;
    end = std::min(line.find_first_of(blanks, begin), line.size());
    result.push_back(line.substr(begin, end - begin));
  }
  return result;
}

std::string plural(std::size_t count, const std::string& word)
{
  return std::to_string(count) + " " + word + (count == 1 ? "" : "s");
}

std::optional<std::size_t> parse_count(const std::string& text)
{
  if(text.empty() || text.size() > 18 || text.find_first_not_of("0123456789") != std::string::npos)
    return std::nullopt;
  return std::stoull(text);
}

} // namespace near_pairs
