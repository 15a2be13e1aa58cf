// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Well-known text, of ISO 19125 and as PostGIS writes it. CGAL's reader sorts the geometries of a
// file by their kinds, and leaves out what it cannot read; here each line keeps its place, and a
// line that cannot be read is an error.

#include "feature.h"

#include "decimal.h"
#include "error.h"

#include <cctype>
#include <cmath>
#include <string_view>
#include <utility>

namespace near_pairs {
namespace {

// The geometry of one line. What is wrong is thrown as std::string.
class Wkt_parser
{
public:
  explicit Wkt_parser(std::string_view text) : text_(text) {}

  Feature feature()
  {
    if(text_.substr(0, 5) == "SRID=")
      text_.remove_prefix(std::min(text_.find(';'), text_.size() - 1) + 1);
    geometry(0);
    if(!next().empty())
      throw "'" + std::string(text_) + "' is behind the geometry";
    return std::move(feature_);
  }

private:
  // The text from the next word or sign on.
  std::string_view next() { return text_ = trimmed(text_); }

  bool take(char sign)
  {
    if(next().empty() || text_.front() != sign)
      return false;
    text_.remove_prefix(1);
    return true;
  }

  void expect(char sign)
  {
    if(!take(sign))
      throw std::string("'") + sign + "' is missing before '" + std::string(text_) + "'";
  }

  std::string_view take_while(bool (*is_part)(unsigned char))
  {
    next();
    std::size_t size = 0;
    while(size < text_.size() && is_part(static_cast<unsigned char>(text_[size])))
      ++size;
    const std::string_view part = text_.substr(0, size);
    text_.remove_prefix(size);
    return part;
  }

  std::string take_word()
  {
    std::string word;
    for(char letter : take_while([](unsigned char byte) { return std::isalpha(byte) != 0; }))
      word += static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
    return word;
  }

  double take_number()
  {
    const std::string_view text = take_while([](unsigned char byte) {
      return std::isalnum(byte) != 0 || byte == '+' || byte == '-' || byte == '.';
    });
    const double value = parse_decimal(text) ? nearest_double(text) : HUGE_VAL;
    if(!std::isfinite(value))
      throw "'" + std::string(text.empty() ? text_ : text) + "' is no finite number";
    return value;
  }

  // Calls `read` for each part of a list.
  template <class Read>
  void list(Read read)
  {
    expect('(');
    do
      read();
    while(take(','));
    expect(')');
  }

  // Heights and measures are left out.
  Vertex position()
  {
    const double x = take_number(), y = take_number();
    for(int more = 0; more < 2 && !next().empty() && text_.front() != ',' && text_.front() != ')';
        ++more)
      take_number();
    return {x, y};
  }

  Vertices positions()
  {
    Vertices vertices;
    list([&] { vertices.push_back(position()); });
    return vertices;
  }

  void point()
  {
    expect('(');
    feature_.lines.push_back({position()});
    expect(')');
  }

  void line()
  {
    feature_.lines.push_back(positions());
    if(feature_.lines.back().size() < 2)
      throw std::string("a line has fewer than two positions");
  }

  void polygon()
  {
    std::vector<Vertices> rings;
    list([&] {
      rings.push_back(positions());
      if(const std::string wrong = open_ring(rings.back()); !wrong.empty())
        throw wrong;
    });
    feature_.polygons.push_back(std::move(rings));
  }

  // The points of a list have parentheses of their own, or none.
  void points()
  {
    list([&] {
      if(!next().empty() && text_.front() == '(')
        point();
      else
        feature_.lines.push_back({position()});
    });
  }

  void geometry(int depth)
  {
    const std::string kind = take_word();
    if(depth > deepest_geometry)
      throw std::string("collections are nested too deep");
    const std::string_view before = next();
    const std::string word = take_word();
    if(word == "EMPTY" || ((word == "Z" || word == "M" || word == "ZM") && take_empty()))
      return;
    if(word != "Z" && word != "M" && word != "ZM")
      text_ = before;
    if(kind == "POINT")
      point();
    else if(kind == "LINESTRING")
      line();
    else if(kind == "POLYGON")
      polygon();
    else if(kind == "MULTIPOINT")
      points();
    else if(kind == "MULTILINESTRING")
      list([&] { line(); });
    else if(kind == "MULTIPOLYGON")
      list([&] { polygon(); });
    else if(kind == "GEOMETRYCOLLECTION")
      list([&] { geometry(depth + 1); });
    else
      throw "'" + kind + "' is no kind of geometry";
  }

  bool take_empty()
  {
    const std::string_view before = next();
    if(take_word() == "EMPTY")
      return true;
    text_ = before;
    return false;
  }

  std::string_view text_; // what is not read yet
  Feature feature_;
};

} // namespace

std::vector<Feature> read_wkt(const Input& input)
{
  std::vector<Feature> features;
  Lines lines(input);
  for(std::string line; lines.next(line); ) {
    const std::string_view text = trimmed(line);
    if(text.empty() || text.front() == '#')
      continue;
    try {
      features.push_back(Wkt_parser(text).feature());
    }
    catch(const std::string& wrong) {
      throw Error(input.name(), lines.number(), wrong);
    }
  }
  return features;
}

} // namespace near_pairs
