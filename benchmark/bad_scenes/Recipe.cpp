// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "bad_scenes/Recipe.h"

#include <cstdlib>
#include <sstream>
#include <stdexcept>

namespace thick_benchmark {
namespace {

std::vector<std::string> split(std::string text, const std::string& separators)
{
  std::vector<std::string> words(1);
  for(const char c : text)
    if(separators.find(c) != std::string::npos)
      words.emplace_back();
    else
      words.back() += c;
  return words;
}

Amount read_amount(const std::string& text)
{
  Amount amount;
  char* rest = nullptr;
  amount.factor = std::strtod(text.c_str(), &rest);
  std::string unit = rest;
  amount.is_in_reaches = unit.rfind("r", 0) == 0;
  if(amount.is_in_reaches)
    unit.erase(0, 1);
  if(unit.rfind("/n", 0) == 0)
    amount.exponent = unit == "/n" ? 1 : std::stod(unit.substr(3));
  else if(rest == text.c_str() || !unit.empty())
    throw std::invalid_argument("This is no number of a recipe: " + text);
  return amount;
}

Change read_change(const std::string& text)
{
  const std::vector<std::string> words = split(text, ":@");
  if(words.size() != 6)
    throw std::invalid_argument("This is no change: " + text);
  return {words[0], std::stoi(words[1]), read_amount(words[2]), read_amount(words[3]), words[4],
          std::stod(words[5])};
}

} // namespace

Recipe read_recipe(const std::string& line)
{
  Recipe recipe;
  std::istringstream words(line);
  words >> recipe.search;
  for(std::string word; words >> word;) {
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(0, equals == std::string::npos ? 0 : equals);
    const std::string value = name.empty() ? word : word.substr(equals + 1);
    if(name == "seed")
      recipe.seed = static_cast<unsigned int>(std::stoul(value));
    else if(name == "r")
      recipe.reach = read_amount(value);
    else if(name == "first")
      recipe.first_share = std::stod(value);
    else if(name.empty())
      recipe.changes.push_back(read_change(value));
    else
      throw std::invalid_argument("This is no part of a recipe: " + word);
  }
  return recipe;
}

} // namespace thick_benchmark
