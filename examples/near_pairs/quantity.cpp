// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Numbers with units; see quantity.h.

#include "quantity.h"

#include <algorithm>
#include <cctype>
#include <map>

namespace near_pairs {
namespace {

std::optional<Exact_number> size_of(const std::map<std::string, const char*>& units,
                                    const std::string& name)
{
  const auto unit = units.find(name);
  return unit == units.end() ? std::nullopt : parse_exact(unit->second);
}

} // namespace

std::optional<Quantity> parse_quantity(const std::string& text)
{
  const auto is_letter = [](unsigned char byte) { return std::isalpha(byte) != 0; };
  const auto end = std::find_if_not(text.rbegin(), text.rend(), is_letter).base();
  const std::string number(trimmed(text.substr(0, end - text.begin())));
  if(const auto value = parse_exact(number))
    return Quantity{*value, number, std::string(end, text.end())};
  return std::nullopt;
}

std::optional<Exact_number> meters_in(const std::string& unit)
{
  return size_of({{"m", "1"}, {"km", "1000"}, {"nmi", "1852"}, {"mi", "1609.344"},
                  {"ft", "0.3048"}}, unit);
}

std::optional<Exact_number> seconds_in(const std::string& unit)
{
  return size_of({{"s", "1"}, {"min", "60"}, {"h", "3600"}}, unit);
}

} // namespace near_pairs
