// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Exact numbers for the files that hand them on. CGAL's number type takes three seconds to compile,
// so only the files that compute with it include it, by rational.h.

#ifndef NEAR_PAIRS_EXACT_NUMBER_H
#define NEAR_PAIRS_EXACT_NUMBER_H

#include "decimal.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace near_pairs {

struct Rational;

class Exact_number
{
public:
  Exact_number(); // zero
  explicit Exact_number(Rational value);

  const Rational* operator->() const { return value_.get(); }

private:
  std::shared_ptr<const Rational> value_;
};

Exact_number operator*(const Exact_number& a, const Exact_number& b);
bool is_negative(const Exact_number& number);
double to_double(const Exact_number& number); // rounded

// Reads a decimal, or a quotient of two decimals such as 1/3.
std::optional<Exact_number> parse_exact(std::string_view text);

// Returns the text of a number that is not negative: a decimal if a short one is exact, otherwise a
// quotient.
std::string exact_text(const Exact_number& number);

// A list in the memory that CGAL's numbers take, and no more.
class Exact_numbers
{
public:
  Exact_numbers();
  Exact_numbers(Exact_numbers&& other) noexcept;
  Exact_numbers& operator=(Exact_numbers&& other) noexcept;
  ~Exact_numbers();

  std::size_t size() const;
  bool empty() const { return size() == 0; }

  void add(const Decimal& decimal);
  void add_scaled(const std::vector<double>& integers, int scale); // divided by 10^scale

  const Rational& operator[](std::size_t at) const;
  double rounded(std::size_t at) const;
  double rounded_difference(std::size_t a, std::size_t b) const;

private:
  std::unique_ptr<std::vector<Rational>> values_;
};

} // namespace near_pairs

#endif // NEAR_PAIRS_EXACT_NUMBER_H
