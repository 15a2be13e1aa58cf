// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "bad_scenes/mutate.h"

#include "bad_scenes/Made_scene.h"

#include <algorithm>

namespace thick_benchmark {
namespace {

const std::size_t max_changes = 7;

class Mutator
{
public:
  Mutator(int dimension, std::mt19937_64& random) : dimension_(dimension), random_(random) {}

  void change_once(Recipe& recipe, const Recipe& other)
  {
    std::vector<Change>& changes = recipe.changes;
    switch(below(10)) {
    case 0: recipe.reach = near(recipe.reach); return;
    case 1: recipe.first_share = share(); return;
    case 2: cross(changes, other.changes); return;
    case 3: recipe.seed = static_cast<unsigned int>(below(1000)); return;
    case 4: case 5: insert(changes, new_change()); return;
    default:
      if(changes.empty())
        insert(changes, new_change());
      else
        alter(changes, below(changes.size()));
    }
  }

private:
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(random_() % n); }
  double unit() { return std::ldexp(static_cast<double>(random_() >> 11), -53); }

  template <class T>
  const T& any_of(const std::vector<T>& all)
  {
    return all[below(all.size())];
  }

  // Two digits, which a text keeps; all of the few digits that the least denormal numbers have.
  static double rounded(double x)
  {
    if(x == 0 || !std::isfinite(x))
      return 0;
    const double unit = std::pow(10, std::floor(std::log10(std::fabs(x))) - 1);
    return unit == 0 ? x : read_amount(to_text(Amount{std::round(x / unit) * unit})).factor;
  }

  double share()
  {
    static const std::vector<double> usual = {0.5, 0.5, 1. / 3, 0.25, 0.1, 0.9, 0.01, 0.99, 0.002};
    return rounded(below(4) == 0 ? unit() : any_of(usual));
  }

  int axis() { return static_cast<int>(below(static_cast<std::size_t>(dimension_) + 2)); }

  Amount new_amount()
  {
    Amount amount;
    static const std::vector<double> usual = {0, 0, 0.5, 1, 1, 2, 4.5, 30, 62, 600};
    amount.factor = below(3) == 0 ? rounded(std::pow(10, -20 * unit() * unit())) : any_of(usual);
    switch(below(8)) {
    case 0: case 1: amount.is_in_reaches = true; break;
    case 2: amount.exponent = 1; break;
    case 3: amount.exponent = 0.5; break;
    case 4: amount.factor *= std::pow(10, 4. * static_cast<double>(below(6)) - 12); break;
    }
    return amount;
  }

  Amount near(Amount amount)
  {
    if(below(5) == 0)
      return new_amount();
    const double scale = below(2) == 0 ? 0.3 : 3; // decades
    if(below(8) == 0)
      amount.exponent += 0.5 * (static_cast<double>(below(3)) - 1);
    amount.factor = rounded(amount.factor * std::pow(10, scale * (2 * unit() - 1)));
    return amount;
  }

  Change new_change()
  {
    return {any_of(kinds_of_changes()), axis(), new_amount(), new_amount(),
            any_of(places_of_changes()), share()};
  }

  void insert(std::vector<Change>& changes, const Change& change)
  {
    changes.insert(changes.begin() + static_cast<std::ptrdiff_t>(below(changes.size() + 1)),
                   change);
    if(changes.size() > max_changes)
      changes.erase(changes.begin() + static_cast<std::ptrdiff_t>(below(changes.size())));
  }

  void alter(std::vector<Change>& changes, std::size_t index)
  {
    Change& change = changes[index];
    switch(below(9)) {
    case 0: changes.erase(changes.begin() + static_cast<std::ptrdiff_t>(index)); return;
    case 1: insert(changes, Change(change)); return;
    case 2: change.axis = axis(); return;
    case 3: case 4: change.a = near(change.a); return;
    case 5: case 6: change.b = near(change.b); return;
    case 7: change.share = share(); return;
    default: change.where = any_of(places_of_changes());
    }
  }

  // Goes on as another recipe does.
  void cross(std::vector<Change>& changes, const std::vector<Change>& others)
  {
    changes.resize(below(changes.size() + 1));
    const std::size_t first = below(others.size() + 1);
    changes.insert(changes.end(), others.begin() + static_cast<std::ptrdiff_t>(first),
                   others.end());
    changes.resize((std::min)(changes.size(), max_changes));
  }

  const int dimension_;
  std::mt19937_64& random_;
};

} // namespace

Recipe mutate(Recipe recipe, const Recipe& other, int dimension, std::mt19937_64& random)
{
  Mutator mutator(dimension, random);
  for(std::size_t count = 1 + random() % 3; count > 0; --count)
    mutator.change_once(recipe, other);
  return recipe;
}

} // namespace thick_benchmark
