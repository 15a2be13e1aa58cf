// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Cells; see cell.h.

#include "cell.h"

#include "decimal.h"
#include "error.h"
#include "rational.h"
#include "text.h"

#include <CGAL/number_utils.h> // abs

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <sstream>

namespace near_pairs {
namespace {

// `what` is what the user calls the cell.
Exact_number number_of(const std::string& text, const std::string& what)
{
  const auto number = parse_exact(trimmed(text));
  if(!number)
    throw Error(what + ": '" + text + "' is no number");
  return *number;
}

// The vectors of so many numbers, one vector after the other.
Cell cell_of_vectors(const std::vector<Exact_number>& numbers, std::size_t dimension)
{
  Cell cell;
  for(std::size_t k = 0; k < dimension; ++k) {
    const auto begin = numbers.begin() + static_cast<std::ptrdiff_t>(k * dimension);
    cell.vectors.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(dimension));
  }
  return cell;
}

Cell cell_of_sides(const std::vector<Exact_number>& sides, const std::string& what)
{
  const std::size_t dimension = sides.size();
  std::vector<Exact_number> numbers(dimension * dimension);
  for(std::size_t k = 0; k < dimension; ++k) {
    if(sides[k]->value <= 0)
      throw Error(what + ": the sides of a cell are positive");
    numbers[k * (dimension + 1)] = sides[k];
  }
  return cell_of_vectors(numbers, dimension);
}

bool truth_of(const std::string& word)
{
  const std::string lower = lower_case(word);
  const bool is_true = lower == "t" || lower == "true" || lower == "1";
  if(!is_true && lower != "f" && lower != "false" && lower != "0")
    throw Error("pbc: '" + word + "' is neither T nor F");
  return is_true;
}

// Rounds unless the factor is that of a right angle.
Exact_number product(const Exact_number& length, double factor)
{
  if(factor == 0 || factor == 1)
    return factor == 0 ? Exact_number() : length;
  return Exact_number(Rational{CGAL::Exact_rational(to_double(length) * factor)});
}

double cosine(const Exact_number& degrees)
{
  return degrees->value == 90 ? 0 : std::cos(to_double(degrees) * std::acos(-1.) / 180);
}

// The first vector is along x, and the second one in the plane of x and y, as usual. The angles are
// those of the second and third vector, of the first and third, and of the first and second.
Cell cell_of_angles(const std::vector<Exact_number>& sides,
                    const std::vector<Exact_number>& degrees, const std::string& what)
{
  const double a = cosine(degrees[0]), b = cosine(degrees[1]), c = cosine(degrees[2]);
  const double sine = std::sqrt(1 - c * c), y = (a - b * c) / sine, z = 1 - b * b - y * y;
  if(!(sine > 0 && z > 0))
    throw Error(what + ": no cell has these angles");
  Cell cell = cell_of_sides(sides, what);
  cell.is_rounded = a != 0 || b != 0 || c != 0;
  cell.vectors[1] = {product(sides[1], c), product(sides[1], sine), Exact_number()};
  cell.vectors[2] = {product(sides[2], b), product(sides[2], y), product(sides[2], std::sqrt(z))};
  return cell;
}

using Matrix = std::array<std::array<double, 3>, 3>;

Matrix matrix_of(const std::vector<Exact_number>& numbers)
{
  Matrix matrix;
  for(std::size_t k = 0; k < 9; ++k)
    matrix[k / 3][k % 3] = to_double(numbers[k]);
  return matrix;
}

// Whether the matrix makes unit vectors of those of the cell, but for the digits that files have:
// five or six of the matrix, and two or three of angles and sides.
bool is_inverse(const Matrix& fractions, const Cell& cell)
{
  const double last_digit = 5e-6, relative = 2e-4;
  for(std::size_t l = 0; l < 3; ++l)
    for(std::size_t k = 0; k < 3; ++k) {
      double sum = k == l ? -1 : 0, size = 0;
      for(std::size_t axis = 0; axis < 3; ++axis) {
        const double component = to_double(cell.vectors[l][axis]);
        sum += fractions[k][axis] * component;
        size += std::abs(component);
      }
      if(!(std::abs(sum) <= relative + last_digit * size))
        return false;
    }
  return true;
}

// Turns a cell whose vectors are along the axes as usual, unless the matrix says the same. Its
// inverse has the vectors as columns: products of two rows.
void turn(Cell& cell, const Matrix& fractions, const std::string& what)
{
  if(is_inverse(fractions, cell))
    return;
  for(std::size_t k = 0; k < 3; ++k) {
    const auto& f = fractions[k];
    const auto& g = fractions[(k + 1) % 3];
    const auto& h = fractions[(k + 2) % 3];
    std::array<double, 3> vector;
    for(std::size_t axis = 0; axis < 3; ++axis)
      vector[axis] = g[(axis + 1) % 3] * h[(axis + 2) % 3] - g[(axis + 2) % 3] * h[(axis + 1) % 3];
    const double determinant = f[0] * vector[0] + f[1] * vector[1] + f[2] * vector[2];
    double old_square = 0, square = 0;
    for(std::size_t axis = 0; axis < 3; ++axis) {
      old_square += std::pow(to_double(cell.vectors[k][axis]), 2);
      square += std::pow(vector[axis] / determinant, 2);
      if(std::isfinite(vector[axis] / determinant))
        cell.vectors[k][axis]
          = Exact_number(Rational{CGAL::Exact_rational(vector[axis] / determinant)});
    }
    if(!(std::abs(square - old_square) <= 0.01 * old_square))
      throw Error(what + ": the matrix of fractions has other sides");
  }
  cell.is_rounded = true;
}

std::string component_text(const Exact_number& number, bool is_rounded)
{
  if(is_rounded)
    return shortest_text(to_double(number));
  const std::string digits = exact_text(Exact_number(Rational{CGAL::abs(number->value)}));
  return is_negative(number) ? "-" + digits : digits;
}

} // namespace

Cell parse_cell(const std::string& text)
{
  const std::string what = "--periodic";
  std::vector<Exact_number> numbers;
  std::istringstream list(text.empty() ? text : text + ','); // what is behind the last one counts
  for(std::string number; numbers.size() < 10 && std::getline(list, number, ','); )
    numbers.push_back(number_of(number, what));
  switch(numbers.size()) {
  case 2: case 3: return cell_of_sides(numbers, what);
  case 4: return cell_of_vectors(numbers, 2);
  case 9: return cell_of_vectors(numbers, 3);
  default:
    throw Error(what + ": a cell has two or three sides, or vectors of four or nine numbers");
  }
}

Cell lattice_cell(const std::vector<std::string>& lattice, const std::vector<std::string>& pbc)
{
  std::vector<Exact_number> numbers;
  for(const std::string& word : lattice)
    numbers.push_back(number_of(word, "Lattice"));
  if(numbers.size() != 3 && numbers.size() != 9)
    throw Error("Lattice: a cell has nine numbers, or three sides");
  Cell cell = numbers.size() == 3 ? cell_of_sides(numbers, "Lattice") : cell_of_vectors(numbers, 3);
  if(pbc.empty())
    return cell;
  if(pbc.size() != 1 && pbc.size() != 3)
    throw Error("pbc: three axes repeat or not, as T T F");
  for(std::size_t k = 0; k < 3; ++k)
    cell.repeats[k] = truth_of(pbc[pbc.size() == 1 ? 0 : k]);
  return cell;
}

Cell crystal_cell(const Crystal& crystal, const std::string& what)
{
  std::vector<Exact_number> sides, degrees;
  for(std::size_t k = 0; k < 3; ++k) {
    sides.push_back(number_of(crystal.sides[k], what));
    degrees.push_back(number_of(crystal.degrees[k], what));
  }
  const auto is_one = [](const Exact_number& side) { return side->value == 1; };
  if(std::all_of(sides.begin(), sides.end(), is_one))
    throw Error(what + ": the sides 1, 1, 1 stand for no cell");
  Cell cell = cell_of_angles(sides, degrees, what);
  std::vector<Exact_number> fractions;
  for(const std::string& number : crystal.fractions)
    fractions.push_back(number_of(number, what));
  if(!fractions.empty())
    turn(cell, matrix_of(fractions), what);
  if(crystal.space_group != "P 1")
    cell.space_group = crystal.space_group;
  return cell;
}

std::string cell_in_words(const Cell& cell)
{
  const std::size_t dimension = cell.vectors.size();
  const auto is_along_its_axis = [&](std::size_t k) {
    for(std::size_t axis = 0; axis < dimension; ++axis)
      if((axis == k) != (cell.vectors[k][axis]->value > 0) || is_negative(cell.vectors[k][axis]))
        return false;
    return true;
  };
  std::string text;
  for(std::size_t k = 0; k < dimension; ++k) {
    text += k == 0 ? "" : ", ";
    if(!cell.repeats[k])
      text += "none";
    else if(is_along_its_axis(k))
      text += component_text(cell.vectors[k][k], cell.is_rounded);
    else
      for(std::size_t axis = 0; axis < dimension; ++axis)
        text += (axis == 0 ? "(" : " ") + component_text(cell.vectors[k][axis], cell.is_rounded)
                + (axis == dimension - 1 ? ")" : "");
  }
  return text + (cell.is_rounded ? ", rounded" : "");
}

} // namespace near_pairs
