#pragma once

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

// Tables of names for values, as commands, reports and Python spell them. Each table is declared beside its type.
namespace gvd {

template <class T>
using Choices = std::vector<std::pair<std::string_view, T>>;

/// All names, in their order.
template <class T>
std::vector<std::string_view> names_in(const Choices<T>& choices) {
  std::vector<std::string_view> names;
  for (const auto& [name, value] : choices) names.push_back(name);
  return names;
}

/// The value of a name; nothing for any other text.
template <class T>
std::optional<T> value_in(const Choices<T>& choices, std::string_view text) {
  for (const auto& [name, value] : choices) {
    if (name == text) return value;
  }
  return std::nullopt;
}

/// The name of a value; empty if it has none.
template <class T>
std::string_view name_in(const Choices<T>& choices, const T& value) {
  for (const auto& [name, named] : choices) {
    if (named == value) return name;
  }
  return "";
}

}  // namespace gvd
