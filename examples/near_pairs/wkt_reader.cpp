// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Well-known text, of ISO 19125 and as PostGIS, GEOS and QGIS write it. CGAL's reader sorts the
// geometries of a file by their kinds, and leaves out what it cannot read; that of GEOS does not
// tell the line. Here each geometry keeps its place, and one that cannot be read is an error.

#include "feature.h"

#include "decimal.h"
#include "error.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

namespace near_pairs {
namespace {

constexpr int end_of_file = -1;

bool is_letter(int sign)
{
  return std::isalpha(sign) != 0;
}

bool is_of_number(int sign)
{
  return std::isalnum(sign) != 0 || sign == '+' || sign == '-' || sign == '.';
}

std::string in_upper_case(std::string text)
{
  for(char& letter : text)
    letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  return text;
}

bool is_no_number(const std::string& text)
{
  const std::string word = in_upper_case(text.substr(text.find_first_not_of("+-") == 1));
  return word == "NAN" || word == "INF" || word == "INFINITY";
}

// Why a kind of geometry is not read.
std::string why_not(const std::string& kind)
{
  for(const char* curves : {"CIRCULARSTRING", "COMPOUNDCURVE", "CURVEPOLYGON", "MULTICURVE",
                            "MULTISURFACE"})
    if(kind == curves)
      return kind + " may have curves, which are not read; ST_CurveToLine of PostGIS makes lines "
                    "of them";
  return kind.empty() ? "a kind of geometry is missing" : "'" + kind + "' is no kind of geometry";
}

// A geometry begins on a line of its own, and ends where its parentheses do.
class Wkt_parser
{
public:
  Wkt_parser(const Input& input, std::string& system) : lines_(input), system_(system) {}

  // Returns false at the end of the file.
  bool next(Feature& feature)
  {
    if(sign() == end_of_file)
      return false;
    feature_ = Feature();
    if(take("SRID"))
      reference_system();
    geometry(0);
    const std::size_t line = lines_.number();
    take(';');
    if(sign() != end_of_file && lines_.number() == line)
      fail("'" + rest() + "' is behind the geometry");
    feature = std::move(feature_);
    return true;
  }

private:
  // The sign in hand: the next one that is no blank and in no comment, on any line.
  int sign()
  {
    while((at_ = std::min(line_.find_first_not_of(" \t\r", at_), line_.size())) == line_.size()) {
      std::string line;
      if(!lines_.next(line))
        return end_of_file;
      line_ = trimmed(line).substr(0, 1) == "#" ? "" : std::move(line);
      at_ = 0;
    }
    return static_cast<unsigned char>(line_[at_]);
  }

  std::string rest() { return sign() == end_of_file ? "" : line_.substr(at_); }

  // Something is wrong with the sign in hand, or with what ends before it.
  [[noreturn]] void fail(const std::string& what) const
  {
    throw Error(lines_.file(), lines_.number(), at_ + 1, what);
  }

  // Of a part that ended with the sign before.
  void check(const std::string& wrong)
  {
    if(wrong.empty())
      return;
    --at_;
    fail(wrong);
  }

  bool take(char wanted)
  {
    const bool is_there = sign() == wanted;
    at_ += is_there;
    return is_there;
  }

  void expect(char wanted)
  {
    if(!take(wanted))
      fail(std::string("'") + wanted + "' is missing before '" + rest() + "'");
  }

  std::string take_while(bool (*is_part)(int))
  {
    sign();
    const std::size_t begin = at_;
    while(at_ < line_.size() && is_part(static_cast<unsigned char>(line_[at_])))
      ++at_;
    return line_.substr(begin, at_ - begin);
  }

  // Takes a word of letters if it is the next one.
  bool take(const std::string& word)
  {
    sign();
    const std::size_t before = at_;
    if(in_upper_case(take_while(is_letter)) == word)
      return true;
    at_ = before;
    return false;
  }

  double take_number(bool may_be_nan = false)
  {
    const std::string text = take_while(is_of_number);
    if(may_be_nan && is_no_number(text))
      return HUGE_VAL;
    const double value = parse_decimal(text) ? nearest_double(text) : HUGE_VAL;
    if(std::isfinite(value))
      return value;
    at_ -= text.size();
    fail("'" + (text.empty() ? rest() : text) + "' is no finite number");
  }

  // Heights and measures are left out, and may be nan. Each position of a geometry has as many
  // numbers as the first one: otherwise a comma is missing.
  Vertex position()
  {
    const double x = take_number(), y = take_number();
    int numbers = 2;
    for(; numbers < 4 && is_of_number(sign()); ++numbers)
      take_number(true);
    if(numbers_ == 0)
      numbers_ = numbers;
    if(numbers != numbers_)
      fail("a position has " + std::to_string(numbers) + " numbers in the place of "
           + std::to_string(numbers_));
    return {x, y};
  }

  // Calls `read` for each part of a list, which is in parentheses, or empty.
  template <class Read>
  void list(Read read)
  {
    if(take("EMPTY"))
      return;
    expect('(');
    do
      read();
    while(take(','));
    expect(')');
  }

  Vertices positions()
  {
    Vertices vertices;
    list([&] { vertices.push_back(position()); });
    return vertices;
  }

  void reference_system()
  {
    expect('=');
    const std::string system = take_while(is_of_number);
    if(!system_.empty() && system != system_)
      fail("SRID " + system + " is not the one before, " + system_);
    system_ = system;
    expect(';');
  }

  void point()
  {
    const Vertices vertices = positions();
    check(vertices.size() > 1 ? "a point has several positions" : "");
    feature_.lines.insert(feature_.lines.end(), vertices.size(), vertices);
  }

  // The points of a list have parentheses of their own, or none.
  void point_of_list()
  {
    if(sign() == '(' || is_letter(sign()))
      point();
    else
      feature_.lines.push_back({position()});
  }

  void line() { check(add_line(feature_, positions())); }

  void ring()
  {
    const Vertices vertices = positions();
    const bool is_open = !vertices.empty() && vertices.front() != vertices.back();
    check(is_open ? "a ring does not end where it begins" : add_line(feature_, vertices));
  }

  void polygon()
  {
    std::vector<Vertices> rings;
    list([&] { rings.push_back(positions()); });
    check(add_polygon(feature_, std::move(rings)));
  }

  void triangle()
  {
    polygon();
    const bool is_triangle = feature_.polygons.empty() || feature_.polygons.back().size() != 1
                             || feature_.polygons.back().front().size() <= 3;
    check(is_triangle ? "" : "a triangle has more than three vertices");
  }

  // Reads a kind of geometry, with Z, M or ZM at its end or behind it. No kind ends with these.
  std::string take_kind()
  {
    std::string kind = in_upper_case(take_while(is_letter));
    for(const std::string dimensions : {"ZM", "Z", "M"})
      if(take(dimensions))
        kind += dimensions;
    const std::size_t size = kind.find_last_not_of("ZM") + 1;
    numbers_ = size == kind.size() ? 0 : 2 + static_cast<int>(kind.size() - size);
    return kind.substr(0, size);
  }

  void geometry(int depth)
  {
    sign();
    const std::size_t line_number = lines_.number(), column = at_ + 1;
    if(depth > deepest_geometry)
      fail("collections are nested too deep");
    const std::string kind = take_kind();
    if(kind == "POINT")
      point();
    else if(kind == "LINESTRING")
      line();
    else if(kind == "LINEARRING")
      ring();
    else if(kind == "POLYGON")
      polygon();
    else if(kind == "TRIANGLE")
      triangle();
    else if(kind == "MULTIPOINT")
      list([&] { point_of_list(); });
    else if(kind == "MULTILINESTRING")
      list([&] { line(); });
    else if(kind == "MULTIPOLYGON" || kind == "POLYHEDRALSURFACE")
      list([&] { polygon(); });
    else if(kind == "TIN")
      list([&] { triangle(); });
    else if(kind == "GEOMETRYCOLLECTION")
      list([&] { geometry(depth + 1); });
    else
      throw Error(lines_.file(), line_number, column, why_not(kind));
  }

  Lines lines_;
  std::string line_;
  std::size_t at_ = 0; // in the line
  Feature feature_;
  std::string& system_; // of reference; empty if no geometry has told it
  int numbers_ = 0;    // of each position of the geometry; 0: not known yet
};

} // namespace

std::vector<Feature> read_wkt(const Input& input, std::string& system)
{
  std::vector<Feature> features;
  Wkt_parser parser(input, system);
  for(Feature feature; parser.next(feature); )
    features.push_back(std::move(feature));
  if(features.empty())
    throw Error(input.name(), "is empty");
  return features;
}

} // namespace near_pairs
