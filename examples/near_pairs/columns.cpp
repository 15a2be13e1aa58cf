// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Names of columns; see columns.h.

#include "columns.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <set>
#include <string_view>
#include <utility>

namespace near_pairs {
namespace {

using Words = std::set<std::string_view>;

// Words for each axis of the plane, and of degrees.
const std::array<Words, 3> plane_words = {
  Words{"x", "xcoord", "xcoordinate", "easting", "eastings"},
  Words{"y", "ycoord", "ycoordinate", "northing", "northings"},
  Words{"z", "zcoord", "zcoordinate"}};
const std::array<Words, 3> degree_words = {
  Words{"lon", "lons", "long", "lng", "longitude", "longitudes", "londeg", "londd"},
  Words{"lat", "lats", "latitude", "latitudes", "latdeg", "latdd"}};

// Words that change nothing about a name, in degrees: the columns of one place may differ by them.
const Words silent_words = {"decimal", "n", "s", "e", "w", "north", "south", "east", "west"};

// Words beside x and y that leave coordinates what they are.
const Words place_words = {"coord", "coords", "coordinate", "coordinates", "pos", "position",
                           "point", "location", "loc", "center", "centre", "centroid", "utm"};

const Words radian_words = {"rad", "radian", "radians"};

// The words of a name, in lower case, without a type or a unit behind it: "lon:float32", "x [m]".
// A word ends before a letter in upper case, as in decimalLatitude and GPSLatitude, and numbers are
// words.
std::vector<std::string> words_of(const std::string& name)
{
  const auto kind = [&](std::size_t at) {
    const auto byte = static_cast<unsigned char>(at < name.size() ? name[at] : ' ');
    return std::isdigit(byte) ? '1' : std::isupper(byte) ? 'A' : std::isalpha(byte) || byte > 127
                              ? 'a' : ' ';
  };
  std::vector<std::string> words;
  char before = ' ';
  const std::size_t end = std::min(name.find_first_of(":([", 1), name.size());
  for(std::size_t at = 0; at < end; ++at) {
    const char here = kind(at);
    const bool goes_on = here == before || (before == 'A' && here == 'a');
    const bool is_last_capital = here == 'A' && before == 'A' && kind(at + 1) == 'a';
    if(here != ' ' && (!goes_on || is_last_capital))
      words.emplace_back();
    if(here != ' ')
      words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(name[at])));
    before = here;
  }
  return words;
}

// A name that has one word of an axis: that axis, and the other words.
struct Meaning
{
  int axis = -1; // none
  std::string others;
  bool are_place_words = true;
};

Meaning meaning_of(const std::string& name, const std::array<Words, 3>& words_of_axes)
{
  Meaning meaning;
  for(const std::string& word : words_of(name)) {
    const auto has_word = [&](const Words& words) { return words.count(word) != 0; };
    const auto axis = std::find_if(words_of_axes.begin(), words_of_axes.end(), has_word);
    if(axis != words_of_axes.end()) {
      if(meaning.axis != -1)
        return Meaning();
      meaning.axis = static_cast<int>(axis - words_of_axes.begin());
    }
    else if(!has_word(silent_words)) {
      meaning.others += ' ' + word;
      meaning.are_place_words = meaning.are_place_words && has_word(place_words);
    }
    if(has_word(radian_words))
      return Meaning();
  }
  return meaning;
}

using Axes = std::array<std::vector<std::size_t>, 3>; // the columns that may have each coordinate

// Takes the one place that the groups of columns have, or tells that there are several.
Column_guess guess_among(const std::map<std::string, Axes>& groups, int dimension)
{
  std::vector<Axes> places;
  for(const auto& [others, axes] : groups)
    if(!axes[0].empty() && !axes[1].empty() && (dimension != 3 || !axes[2].empty()))
      places.push_back(axes);
  const std::size_t axis_count = dimension == 2 ? 2 : 3;
  Column_guess guess;
  bool is_sure = places.size() == 1;
  for(const Axes& axes : places)
    for(std::size_t axis = 0; axis < axis_count; ++axis) {
      guess.rivals.insert(guess.rivals.end(), axes[axis].begin(), axes[axis].end());
      is_sure = is_sure && axes[axis].size() <= 1;
    }
  if(is_sure)
    guess.columns.swap(guess.rivals);
  std::sort(guess.rivals.begin(), guess.rivals.end());
  return guess;
}

// Groups columns by the words besides those of their axes. Beside x and y, only some words are
// known to leave a coordinate a coordinate.
Column_guess guess_by(const std::vector<std::string>& names, bool in_degrees, bool of_one_word,
                      int dimension)
{
  std::map<std::string, Axes> groups;
  for(std::size_t column = 0; column < names.size(); ++column) {
    const Meaning meaning = meaning_of(names[column], in_degrees ? degree_words : plane_words);
    const bool is_wanted
      = of_one_word ? meaning.others.empty() : in_degrees || meaning.are_place_words;
    if(meaning.axis != -1 && is_wanted)
      groups[meaning.others][meaning.axis].push_back(column);
  }
  Column_guess guess = guess_among(groups, dimension);
  guess.are_degrees = in_degrees;
  return guess;
}

bool has_axis(const std::string& name, int axis)
{
  return meaning_of(name, degree_words).axis == axis || meaning_of(name, plane_words).axis == axis;
}

} // namespace

Column_guess guess_columns(const std::vector<std::string>& names, bool latitude_first,
                           int dimension)
{
  for(bool of_one_word : {true, false})
    for(bool in_degrees : {false, true}) {
      if(in_degrees ? dimension == 3 : latitude_first)
        continue;
      Column_guess guess = guess_by(names, in_degrees, of_one_word, in_degrees ? 2 : dimension);
      if(latitude_first && guess.columns.size() == 2)
        std::swap(guess.columns[0], guess.columns[1]);
      if(!guess.columns.empty() || !guess.rivals.empty())
        return guess;
    }
  return Column_guess();
}

bool is_latitude(const std::string& name)
{
  return has_axis(name, 1);
}

bool is_longitude(const std::string& name)
{
  return has_axis(name, 0);
}

} // namespace near_pairs
