#pragma once

#include <concepts>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "gvd/object.hpp"

// Helpers with which objects visit their figures, the columns of their tables, and their lists.
namespace gvd {

/// Converts a value of any type of whole numbers, ids or texts to a type of Figure. An optional without a value becomes
/// an empty figure.
template <class T>
auto plain(const T& value) {
  if constexpr (std::is_same_v<T, bool> || std::is_floating_point_v<T>) {
    return value;
  } else if constexpr (std::is_integral_v<T>) {
    return std::int64_t(value);
  } else if constexpr (requires {
                         { value.index() } -> std::same_as<std::size_t>;
                         value.valid();
                       }) {  // a typed id
    return std::int64_t(value.value());
  } else if constexpr (requires { value.has_value(); }) {
    return value ? Figure(plain(*value)) : Figure();
  } else if constexpr (std::is_convertible_v<T, std::string_view>) {
    return std::string(value);
  } else {
    return value;
  }
}

/// The values that `value` returns for the elements of a range.
template <class Range, class Value = std::identity>
auto each_of(const Range& range, const Value& value = {}) {
  std::vector<decltype(plain(std::invoke(value, *std::begin(range))))> values;
  for (const auto& element : range) values.push_back(plain(std::invoke(value, element)));
  return values;
}

/// The value of an optional, or a default-constructed one, whose arrays are empty.
template <class T>
const T& or_none(const std::optional<T>& value) {
  static const T kNone{};
  return value ? *value : kNone;
}

/// Visits the figures of a group, whose names begin with the name of the group. With `are_there` false, the figures are
/// visited without values.
class Figures {
 public:
  explicit Figures(ObjectVisitor& visitor, std::string group = "", bool are_there = true)
      : visitor_(visitor), group_(std::move(group)), are_there_(are_there) {}

  template <class T>
  void operator()(const char* name, const char* unit, const char* text, const T& value) const {
    const std::string whole = group_.empty() ? name : group_ + '.' + name;
    visitor_.figure({whole, unit, text}, are_there_ ? Figure(plain(value)) : Figure());
  }

 private:
  ObjectVisitor& visitor_;
  std::string group_;
  bool are_there_;
};

/// The lists that `member` returns for the elements.
template <class S, class Member>
auto lists_of(const std::vector<S>& values, const Member& member) {
  using T = typename std::remove_cvref_t<std::invoke_result_t<Member, const S&>>::value_type;
  return Lists<T>{std::ssize(values), [&values, member](std::int64_t i) {
                    return std::span<const T>(std::invoke(member, values[std::size_t(i)]));
                  }};
}

}  // namespace gvd
