// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Triangles in the format STL; see stl_reader.h.

#include "stl_reader.h"

#include "error.h"
#include "text.h"

#include <cstdint>
#include <ios>
#include <istream>
#include <string>

namespace near_pairs {
namespace {

constexpr Number_type byte = {1, Number_type::UNSIGNED}, count_of_facets = {4, byte.kind};
constexpr Number_type real_of_facet = {4, Number_type::FLOATING};
constexpr std::size_t bytes_of_title = 80, bytes_of_facet = 50, bytes_of_normal = 12;
constexpr std::size_t bytes_of_attribute = 2;

// Whether the input is binary. Throws Error if it is, and has not as many bytes as the count behind
// its title promises. The highest byte of a count is 0, and no byte of a text is.
bool is_binary_stl(const Input& input)
{
  const std::unique_ptr<std::istream> bytes = input.open();
  std::string head(bytes_of_title + count_of_facets.bytes, ' ');
  bytes->read(head.data(), static_cast<std::streamsize>(head.size()));
  std::streamsize facets = 0;
  for(std::size_t i = count_of_facets.bytes; i > 0; --i)
    facets = facets << 8 | static_cast<unsigned char>(head[bytes_of_title + i - 1]);
  const std::streamsize size = facets * static_cast<std::streamsize>(bytes_of_facet);
  if(*bytes && bytes->ignore(size) && bytes->gcount() == size
     && bytes->peek() == std::istream::traits_type::eof())
    return true;
  if(head.find('\0') != std::string::npos)
    throw Error(input.name(), "has another size than the binary file of "
                + plural(static_cast<std::size_t>(facets), "facet") + " that it promises");
  return false;
}

} // namespace

Stl_reader::Stl_reader(const Input& input, const Read_options& options)
  : numbers_(input, options)
{
  dimension = 3;
  face_.corners.resize(3);
  if(is_binary_stl(input)) {
    numbers_.become_binary(Numbers::LEAST_FIRST);
    numbers_.skip(bytes_of_title, byte);
    numbers_.take(count_of_facets);
    facets_ = numbers_.count();
    return;
  }
  if(!numbers_.next_word() || lower_case(std::string(numbers_.word())) != "solid")
    throw Error(input.name(), "begins with no 'solid', and is not binary either");
  begin_solid();
}

bool Stl_reader::next(Row& row)
{
  if(vertex_ == 3)
    end_facet();
  if(vertex_ == 0 && !begin_facet())
    return false;
  if(!facets_)
    expect("vertex");
  for(std::string& coordinate : row.coordinates) {
    numbers_.take(real_of_facet);
    coordinate = numbers_.coordinate();
  }
  row.line = facets_ ? 0 : numbers_.line();
  face_.corners[vertex_] = 3 * (facet_ - 1) + vertex_;
  ++vertex_;
  return true;
}

// Returns false at the end of the file.
bool Stl_reader::begin_facet()
{
  if(!facets_ && !begin_facet_of_text())
    return false;
  if(facets_) {
    if(facet_ == *facets_)
      return false;
    numbers_.begin("facet", facet_, *facets_);
    numbers_.skip(bytes_of_normal, byte);
  }
  face_.line = facets_ ? 0 : numbers_.line();
  face_.solid = solids.size() - 1;
  ++facet_;
  return true;
}

bool Stl_reader::begin_facet_of_text()
{
  while(numbers_.next_word()) {
    const std::string word = lower_case(std::string(numbers_.word()));
    if(is_in_solid_ && word == "facet") {
      skip_line();
      expect("outer");
      expect("loop");
      return true;
    }
    if(is_in_solid_ ? word != "endsolid" : word != "solid")
      throw numbers_.wrong(std::string("neither ") + (is_in_solid_ ? "facet nor endsolid"
                                                                   : "solid nor the end"));
    if(is_in_solid_)
      skip_line();
    else {
      solids.emplace_back();
      begin_solid();
    }
    is_in_solid_ = word == "solid";
  }
  if(is_in_solid_)
    throw numbers_.wrong("the file ends before endsolid");
  return false;
}

// The name is the rest of the line.
void Stl_reader::begin_solid()
{
  is_in_solid_ = true;
  std::string& name = solids.back();
  while(numbers_.next_word_of_line())
    name += (name.empty() ? "" : " ") + std::string(numbers_.word());
}

void Stl_reader::end_facet()
{
  vertex_ = 0;
  if(facets_)
    numbers_.skip(bytes_of_attribute, byte);
  else {
    expect("endloop");
    expect("endfacet");
  }
  if(take_face)
    take_face(face_);
}

void Stl_reader::expect(const char* word)
{
  if(!numbers_.next_word() || lower_case(std::string(numbers_.word())) != word)
    throw numbers_.wrong(std::string("'") + word + "' is missing");
}

void Stl_reader::skip_line()
{
  while(numbers_.next_word_of_line())
    ;
}

} // namespace near_pairs
