// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The choice of a format; see row_reader.h.

#include "row_reader.h"

#include "cif_reader.h"
#include "csv_reader.h"
#include "decimal.h"
#include "error.h"
#include "mesh_reader.h"
#include "pdb_reader.h"
#include "present_rows.h"
#include "text.h"
#include "tsp_reader.h"
#include "xyz_reader.h"

#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <utility>

namespace near_pairs {

void Row_reader::require_frame(const std::string& file) const
{
  if(frame.number > frame.count)
    throw Error(file, "no frame " + std::to_string(frame.number) + ": the file has "
                + plural(frame.count, "frame"));
}

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
  return !options.columns.empty() ? "--columns"
         : !options.id.empty() ? "--id"
         : options.no_header ? "--no-header"
         : options.comma_numbers ? "--comma-numbers"
         : options.separator != 0 ? "--separator"
         : !options.altitude.empty() ? "--altitude" : "";
}

// Returns nothing if the format is unknown. The vertices of .stl files are no list of points, since
// each triangle repeats its own.
std::unique_ptr<Row_reader> reader_of(const std::string& format, const Input& input,
                                      const Read_options& options)
{
  if(format == "xyz")
    return std::make_unique<Xyz_reader>(input, options);
  if(format == "tsp")
    return std::make_unique<Tsp_reader>(input, options);
  if(format == "pdb" || format == "ent")
    return std::make_unique<Pdb_reader>(input, options);
  if(is_cif(format))
    return std::make_unique<Cif_reader>(input, options);
  if(format != "stl")
    return make_mesh_reader(format, input, options);
  throw Error(input.name(), "has triangles alone, which --solids reads");
}

// What to do with files that other programs read: Debian 12 has no library for LAS and LAZ.
std::string advice_on(const std::string& format)
{
  return format == "las" || format == "laz" ? " ('pdal translate' makes a .csv file of this one)"
                                            : "";
}

} // namespace

void refuse_options_for_tables(const Input& input, const Read_options& options, bool are_degrees)
{
  const std::string option
    = options.geographic && !are_degrees ? "--geographic" : option_for_tables(options);
  if(!option.empty())
    throw Error(input.name(), option + " needs a table, such as a .csv file");
}

std::unique_ptr<Row_reader> open_rows(const Input& input, const Read_options& options)
{
  const std::string format = format_of(input.name(), options);
  if(is_table(input.name(), options))
    return std::make_unique<Csv_reader>(input, options);
  auto reader = reader_of(format, input, options);
  if(!reader)
    throw Error(input.name(), "unknown format; name one of csv (for any table), xyz, off, ply, "
                "obj, pdb, cif, tsp, bin, wkt and geojson by --format" + advice_on(format));
  refuse_options_for_tables(input, options, reader->latitude_axis != -1);
  reader->may_skip_missing = options.may_skip_missing;
  if(options.skip_missing)
    return std::make_unique<Present_rows>(std::move(reader));
  return reader;
}

std::string guessed_columns(const Row_reader& reader)
{
  const std::size_t longest = 30; // letters
  std::string list;
  const int guessed = reader.latitude_axis == 0 ? 2 : reader.dimension; // no altitude
  for(int axis = 0; reader.are_guessed && axis < guessed; ++axis)
    list += (axis == 0 ? "" : ", ") + shortened(readable(reader.names[axis]), longest);
  return list;
}

bool is_table(const std::string& file, const Read_options& options)
{
  const std::initializer_list<const char*> tables = {"csv", "tsv", "txt", "dat"};
  return std::find(tables.begin(), tables.end(), format_of(file, options)) != tables.end();
}

bool is_cif(const std::string& format)
{
  return format == "cif" || format == "mmcif";
}

bool has_frames(const std::string& file, const Read_options& options)
{
  const std::string format = format_of(file, options);
  return format == "xyz" || format == "pdb" || format == "ent" || is_cif(format);
}

bool is_binary(const Input& input, const Read_options& options)
{
  if(format_of(input.name(), options) != "bin")
    return false;
  refuse_options_for_tables(input, options);
  if(options.skip_missing)
    throw Error(input.name(), "--skip-missing needs numbers that are text, or a mesh");
  return true;
}

std::string extension(const std::string& file)
{
  return lower_case(std::filesystem::path(file).extension().string());
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
