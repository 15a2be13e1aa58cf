// Copyright (c) 2026 The Thick_intersection_d authors.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_KINDS_H
#define CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_KINDS_H

// Objects of several kinds in one search: variants, objects of two ranges that differ in type,
// objects of classes that derive from their kind, and objects with a radius.

#include <CGAL/Kernel_traits.h>

#include <CGAL/Thick_intersection_d/internal/arithmetic/exact_number.h>
#include <CGAL/Thick_intersection_d/internal/input/base_kind.h>
#include <CGAL/Thick_intersection_d/internal/input/dimensions.h>
#include <CGAL/Thick_intersection_d/internal/machine/hints.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>

namespace CGAL {
namespace Thick_intersection_d {
namespace internal {

// Whether an object may be thickened by a radius: whether the package knows its kind.
template <class Object>
struct Has_vertices : std::bool_constant<Vertex_count<Base_kind_t<Object>>::value != 0> {};

// Whether a type of numbers is that of the coordinates of points, or of objects with vertices.
template <class Object, class NT, class = void>
struct Is_coordinate : std::false_type {};
template <class Point, class NT>
struct Is_coordinate<Point, NT, std::enable_if_t<Is_point<Point>::value>>
  : std::is_same<NT, std::decay_t<decltype(std::declval<const Point&>().cartesian(0))>> {};
template <class Object, class NT>
struct Is_coordinate<
  Object, NT, std::enable_if_t<!Is_point<Object>::value && Has_vertices<Object>::value>>
  : std::is_same<NT, typename Kernel_traits<Base_kind_t<Object>>::Kernel::FT> {};

// Whether an object is a pair of an object and an integer, which may be meant as an index.
template <class Object, class = void>
struct Is_object_with_index : std::false_type {};
template <class Object>
struct Is_object_with_index<Object, std::void_t<typename Object::second_type>>
  : std::bool_constant<
      (Is_point<typename Object::first_type>::value
       || Has_vertices<typename Object::first_type>::value)
      && std::is_integral_v<typename Object::second_type>
      && !Is_coordinate<typename Object::first_type, typename Object::second_type>::value>
{};

// Whether an object is thickened by a radius: all points within the radius of it. A point with a
// radius is a closed ball. An object of a class with a test of its own is what the test says.
template <class Object, class = void>
struct Is_thickened : std::false_type {};
template <class Object>
struct Is_thickened<Object, std::void_t<typename Object::second_type>>
  : std::bool_constant<Has_vertices<typename Object::first_type>::value
                       && is_number_v<typename Object::second_type>
                       && !Is_object_with_index<Object>::value
                       && !Has_own_test<Object, Object>::value>
{};

// The object without its radius, if it has one: all points of the object are within the radius of
// the hull of a few points.
template <class Object>
decltype(auto) hull_points(const Object& object)
{
  if constexpr(Is_thickened<Object>::value)
    return as_base(object.first);
  else
    return (object);
}

template <class Object>
using Hull_points_t = std::decay_t<decltype(hull_points(std::declval<const Object&>()))>;

// Refers to an object that a range holds. Holds one that the range makes.
template <class Reference>
class Range_object
{
public:
  explicit Range_object(Reference object) : object_(std::forward<Reference>(object)) {}
  const std::decay_t<Reference>& get() const { return object_; }

private:
  std::conditional_t<std::is_lvalue_reference_v<Reference>,
                     std::reference_wrapper<const std::decay_t<Reference>>,
                     std::decay_t<Reference>> object_;
};

// An object of the first range or of the second, which give A and B.
template <class A, class B>
class One_of_two
{
public:
  using First = std::decay_t<A>;
  using Second = std::decay_t<B>;

  One_of_two(std::in_place_index_t<0> first, A object) : object_(first, std::forward<A>(object)) {}
  One_of_two(std::in_place_index_t<1> second, B object) : object_(second, std::forward<B>(object))
  {}

  bool is_first() const { return object_.index() == 0; }
  const First& first() const { return std::get_if<0>(&object_)->get(); }
  const Second& second() const { return std::get_if<1>(&object_)->get(); }

private:
  std::variant<Range_object<A>, Range_object<B>> object_;
};

// The types that an object may be of.
template <class Object>
struct Types_of
{
  using type = std::tuple<Object>;
};
template <class... Types>
struct Types_of<std::variant<Types...>>
{
  using type = decltype(std::tuple_cat(std::declval<typename Types_of<Types>::type>()...));
};
template <class A, class B>
struct Types_of<One_of_two<A, B>>
{
  using type = decltype(std::tuple_cat(std::declval<typename Types_of<std::decay_t<A>>::type>(),
                                       std::declval<typename Types_of<std::decay_t<B>>::type>()));
};

template <class Types>
struct Kinds_of_types;
template <class... Types>
struct Kinds_of_types<std::tuple<Types...>>
{
  using type = std::tuple<Kind_t<Types>...>;
};

// The kinds that an object may be of.
template <class Object>
struct Kinds_of : Kinds_of_types<typename Types_of<Object>::type>
{};

template <class A, class... Types>
constexpr bool has_own_test_with(std::tuple<Types...>*)
{
  return (Has_own_test<A, Types>::value || ...);
}
template <class... Types>
constexpr bool has_own_tests(std::tuple<Types...>* types)
{
  return (has_own_test_with<Types>(types) || ...);
}

// Whether two objects of a range, or of two, may have an intersection test of their own.
template <class Object>
inline constexpr bool has_own_tests_v
  = has_own_tests(static_cast<typename Types_of<Object>::type*>(nullptr));

template <class Kinds>
struct Kind_list;
template <class... Kinds>
struct Kind_list<std::tuple<Kinds...>>
{
  using First = std::tuple_element_t<0, std::tuple<Kinds...>>;

  template <template <class...> class Property>
  static constexpr bool are_all = (Property<Kinds>::value && ...);
  template <template <class...> class Property>
  static constexpr bool is_any = (Property<Kinds>::value || ...);
};

template <class Object>
using Kinds = Kind_list<typename Kinds_of<Object>::type>;

// Whether the package knows what objects of a kind are.
template <class Kind>
struct Is_known_kind
  : std::bool_constant<Vertex_count<Kind>::value != 0 || Is_thickened<Kind>::value>
{};

// Whether the package decides about all pairs of objects of a range, or of two.
template <class Object>
inline constexpr bool are_tests_known_v
  = Kinds<Object>::template are_all<Is_known_kind> && !has_own_tests_v<Object>;

template <class Object>
struct Is_variant : std::false_type {};
template <class... Kinds>
struct Is_variant<std::variant<Kinds...>> : std::true_type {};

template <class Object>
struct Is_one_of_two : std::false_type {};
template <class A, class B>
struct Is_one_of_two<One_of_two<A, B>> : std::true_type {};

// Whether an object is one of those of a range, or of one of two ranges.
template <class Given, class Object>
struct Is_object_of : std::is_convertible<const Given&, const Object&> {};
template <class Given, class A, class B>
struct Is_object_of<Given, One_of_two<A, B>>
  : std::disjunction<std::is_same<Given, std::decay_t<A>>, std::is_same<Given, std::decay_t<B>>>
{};

// Whether an object has another type than its kind: only the object itself knows its kind, or its
// class derives from that of its kind.
template <class Object>
inline constexpr bool is_mixed_v = Is_variant<Object>::value || Is_one_of_two<Object>::value
                                   || !std::is_same_v<Kind_t<Object>, Object>;

// Returns task(object) for an object of a range.
template <class Object, class Task>
auto of_range(const Object& object, const Task& task)
{
  if constexpr(Is_one_of_two<Object>::value)
    return object.is_first() ? task(object.first()) : task(object.second());
  else
    return task(object);
}

// Returns test(a, b) for two objects of a range, or for one of each of two ranges.
template <class Object, class Test>
bool of_ranges(const Object& a, const Object& b, const Test& test)
{
  if constexpr(Is_one_of_two<Object>::value)
    return a.is_first() ? test(a.first(), b.second()) : test(b.first(), a.second());
  else
    return test(a, b);
}

// Returns task(object) for what an object holds. The result has the same type for all types.
template <class Object, class Task>
auto with_type(const Object& object, const Task& task)
{
  if constexpr(Is_variant<Object>::value)
    return std::visit([&](const auto& x) { return with_type(x, task); }, object);
  else if constexpr(Is_one_of_two<Object>::value)
    return of_range(object, [&](const auto& x) { return with_type(x, task); });
  else
    return task(object);
}

// The same for what an object is.
template <class Object, class Task>
auto with_kind(const Object& object, const Task& task)
{
  return with_type(object, [&](const auto& x) { return task(as_kind(x)); });
}

// Returns test(a, b) for what two objects of a range hold, or one of each of two ranges.
template <class Object, class Test>
bool with_types(const Object& a, const Object& b, const Test& test)
{
  return of_ranges(a, b, [&](const auto& range_a, const auto& range_b) {
    return with_type(range_a, [&](const auto& x) {
      return with_type(range_b, [&](const auto& y) { return test(x, y); });
    });
  });
}

// The same for what the objects are.
template <class Object, class Test>
bool with_kinds(const Object& a, const Object& b, const Test& test)
{
  return with_types(a, b, [&](const auto& x, const auto& y) {
    return test(as_kind(x), as_kind(y));
  });
}

// Prefetches an object, if the range holds it.
template <class Elements>
void prefetch_object([[maybe_unused]] const Elements& objects,
                     [[maybe_unused]] std::size_t position)
{
  const auto prefetch = [](const auto& object) {
    const auto* const first = reinterpret_cast<const char*>(std::addressof(object));
    for(std::size_t line = 0; line * cache_line_size < sizeof(object); ++line)
      prefetch_to_read(first, line);
    prefetch_to_read(first + sizeof(object) - 1); // it may begin in the middle of a line
  };
  if constexpr(Is_one_of_two<typename Elements::value_type>::value)
    of_range(objects[position], prefetch);
  else if constexpr(std::is_lvalue_reference_v<decltype(objects[position])>)
    prefetch(objects[position]);
}

} // namespace internal
} // namespace Thick_intersection_d
} // namespace CGAL

#endif // CGAL_THICK_INTERSECTION_D_INTERNAL_INPUT_KINDS_H
