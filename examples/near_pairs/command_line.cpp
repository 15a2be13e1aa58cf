// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Parts of the command line; see command_line.h.

#include "command_line.h"

#include "decimal.h"

#include <algorithm>
#include <sstream>

namespace near_pairs {

po::options_description group(const char* title)
{
  return po::options_description(title, columns_of_help, columns_of_descriptions);
}

std::string text_for_file(const po::variables_map& map, const std::string& option,
                          std::size_t file)
{
  if(!map.count(option))
    return "";
  const Texts& texts = map[option].as<Texts>();
  return texts.size() == 1 ? texts.front() : texts[file];
}

bool are_all_empty(const Texts& texts)
{
  return std::all_of(texts.begin(), texts.end(), [](const auto& text) { return text.empty(); });
}

Texts split_at_commas(const std::string& text)
{
  Texts names;
  std::istringstream list(text.empty() ? text : text + ',');
  for(std::string name; std::getline(list, name, ','); )
    names.emplace_back(trimmed(name));
  return names;
}

} // namespace near_pairs
