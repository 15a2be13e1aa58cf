// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Meshes in the format OFF; see off_reader.h.

#include "off_reader.h"

#include "error.h"

#include <utility>

namespace near_pairs {
namespace {

constexpr Number_type integer = {4, Number_type::SIGNED}, real = {4, Number_type::FLOATING};

// Removes letters from a word if it has them.
bool take_letters(std::string& word, const std::string& letters)
{
  const std::size_t place = word.find(letters);
  if(place != std::string::npos)
    word.erase(place, letters.size());
  return place != std::string::npos;
}

} // namespace

Off_reader::Off_reader(const Input& input, const Read_options& options)
  : numbers_(input, options, '#')
{
  read_keyword();
  read_counts();
  if(options.dimension > static_cast<int>(coordinates_))
    throw Error(input.name(), "the vertices have no third coordinate");
  dimension = options.dimension == 0 ? static_cast<int>(coordinates_) : options.dimension;
}

// The keyword is [ST][C][N][4][n]OFF; MeshLab has the letters in another order. It may be missing,
// and the first count may follow at once.
void Off_reader::read_keyword()
{
  numbers_.next_word();
  const std::string word(numbers_.word());
  const std::size_t end = word.find("OFF");
  if(end == std::string::npos && parse_count(word)) {
    numbers_.shorten_word(0);
    return;
  }
  std::string letters = word.substr(0, end);
  has_textures_ = take_letters(letters, "ST");
  has_colors_ = take_letters(letters, "C");
  has_normals_ = take_letters(letters, "N");
  if(take_letters(letters, "4"))
    throw numbers_.wrong("vertices with four homogeneous coordinates (4OFF) are not read");
  const bool tells_dimension = take_letters(letters, "n");
  if(end == std::string::npos || !letters.empty())
    throw numbers_.wrong("does not begin with OFF, with none or some of ST, C, N and n before it");
  numbers_.shorten_word(end + 3);
  if(numbers_.next_word_of_line()) {
    if(numbers_.word() == "BINARY")
      numbers_.become_binary(Numbers::MOST_FIRST);
    else
      numbers_.shorten_word(0);
  }
  if(tells_dimension)
    coordinates_ = take_count();
  if(coordinates_ != 2 && coordinates_ != 3)
    throw numbers_.wrong("vertices have 2 or 3 coordinates");
}

// The number of edges may be wrong, but it must be there: without it, the first coordinate would be
// taken for it.
void Off_reader::read_counts()
{
  vertices_ = take_count();
  faces_ = take_count();
  if(!numbers_.are_binary() && numbers_.count_words_of_line(1) == 0)
    throw numbers_.wrong("the number of edges is missing behind those of vertices and faces");
  take_count();
}

std::size_t Off_reader::take_count()
{
  numbers_.take(integer);
  return numbers_.count();
}

bool Off_reader::next(Row& row)
{
  if(count_ == vertices_) {
    read_faces();
    return false;
  }
  numbers_.begin("vertex", count_, vertices_);
  for(std::size_t axis = 0; axis < coordinates_; ++axis) {
    numbers_.take(real);
    if(static_cast<int>(axis) < dimension)
      row.coordinates[axis] = numbers_.coordinate();
  }
  row.line = numbers_.line();
  numbers_.skip(has_normals_ ? 3 : 0, real);
  // A color has four numbers, but many programs write three on the line of a vertex.
  const std::size_t textures = has_textures_ ? 2 : 0;
  if(has_colors_ && colors_ == 0)
    colors_ = !numbers_.are_binary() && numbers_.count_words_of_line(6) == 3 + textures ? 3 : 4;
  numbers_.skip(colors_ + textures, real);
  ++count_;
  return true;
}

// Also proves that the vertices are where they have been read.
void Off_reader::read_faces()
{
  const std::size_t faces = std::exchange(faces_, 0);
  for(std::size_t face = 0; face < faces; ++face) {
    numbers_.begin("face", face, faces);
    Face in_hand;
    for(std::size_t corner = take_count(); corner > 0; --corner) {
      const std::size_t vertex = take_count();
      if(in_hand.corners.size() <= most_corners)
        in_hand.corners.push_back(vertex);
      if(vertex >= vertices_)
        throw numbers_.wrong("a face has a corner that is no vertex (they count from 0)");
    }
    in_hand.line = numbers_.are_binary() ? 0 : numbers_.line();
    read_color();
    if(take_face)
      take_face(in_hand);
  }
  numbers_.expect_end();
}

// The color of a face: one, three or four numbers at the end of the line, or none.
void Off_reader::read_color()
{
  if(numbers_.are_binary()) {
    numbers_.skip(take_count(), real);
    return;
  }
  std::size_t count = 0;
  while(numbers_.next_word_of_line())
    ++count;
  if(count == 2 || count > 4)
    throw numbers_.wrong("the color of a face has " + std::to_string(count) + " numbers");
}

} // namespace near_pairs
