// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "bad_scenes/Recipe.h"

namespace thick_benchmark {
namespace {

std::string to_text(const Change& change)
{
  std::ostringstream text;
  text << change.kind << ':' << change.axis << ':' << to_text(change.a) << ':'
       << to_text(change.b) << '@' << change.where << ':' << change.share;
  return text.str();
}

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

Change read_change(const std::string& text)
{
  const std::vector<std::string> words = split(text, ":@");
  if(words.size() != 6)
    throw std::invalid_argument("This is no change: " + text);
  return {words[0], std::stoi(words[1]), read_amount(words[2]), read_amount(words[3]), words[4],
          std::stod(words[5])};
}

} // namespace

std::string to_text(const Recipe& recipe)
{
  std::ostringstream text;
  text << recipe.search << " n=" << recipe.n << " seed=" << recipe.seed
       << " r=" << to_text(recipe.reach) << " first=" << recipe.first_share;
  for(const Change& change : recipe.changes)
    text << ' ' << to_text(change);
  return text.str();
}

Recipe read_recipe(const std::string& line)
{
  Recipe recipe;
  std::istringstream words(line);
  words >> recipe.search;
  for(std::string word; words >> word;) {
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(0, equals == std::string::npos ? 0 : equals);
    const std::string value = name.empty() ? word : word.substr(equals + 1);
    if(name == "n")
      recipe.n = std::stoul(value);
    else if(name == "seed")
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
