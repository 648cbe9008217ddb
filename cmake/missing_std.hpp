#pragma once

// What libgvd takes from C++20's library and libc++ 13, that of emscripten 3.1.6, lacks. The compiler includes this
// file first in every source of the web module (cmake/find_libraries.cmake); nothing else of the project knows of it.
// Sources: range-v3, from which std::ranges was made, and fast_float, which g++'s std::from_chars uses.

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstring>
#include <functional>
#include <memory>
#include <range/v3/algorithm.hpp>
#include <type_traits>

namespace std {

template <class To, class From>
To bit_cast(const From& from) noexcept {
  static_assert(sizeof(To) == sizeof(From) && is_trivially_copyable_v<To> && is_trivially_copyable_v<From>);
  To to;
  memcpy(&to, &from, sizeof(To));
  return to;
}

template <class T>
unique_ptr<T> make_unique_for_overwrite(size_t count) {
  return unique_ptr<T>(new remove_extent_t<T>[count]);
}

/// Infinity or 0 beyond the range of a double, without an error.
inline from_chars_result from_chars(const char* first, const char* last, double& value) {
  const fast_float::from_chars_result result = fast_float::from_chars(first, last, value);
  return {result.ptr, result.ec};
}

/// The same digits as std::to_chars, sometimes in another notation.
inline to_chars_result to_chars(char* first, char*, double value) {
  return {fmt::format_to(first, "{}", value), errc()};
}

namespace ranges {
/// That of range-v3 0.12 leaves some of the vectors empty that are members of what it sorts.
template <class Range, class Compare = std::less<>, class Projection = ::ranges::identity>
void stable_sort(Range&& range, Compare compare = {}, Projection projection = {}) {
  std::stable_sort(range.begin(), range.end(), [&](const auto& a, const auto& b) {
    return std::invoke(compare, std::invoke(projection, a), std::invoke(projection, b));
  });
}

using ::ranges::all_of, ::ranges::any_of, ::ranges::binary_search, ::ranges::copy, ::ranges::copy_if, ::ranges::count,
    ::ranges::count_if, ::ranges::equal, ::ranges::fill, ::ranges::find, ::ranges::find_if, ::ranges::for_each,
    ::ranges::is_sorted, ::ranges::lower_bound, ::ranges::max, ::ranges::max_element, ::ranges::merge, ::ranges::min,
    ::ranges::min_element, ::ranges::minmax_element, ::ranges::move, ::ranges::none_of, ::ranges::set_difference,
    ::ranges::sort, ::ranges::upper_bound;
}  // namespace ranges

}  // namespace std
