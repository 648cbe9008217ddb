#pragma once

#include <fmt/format.h>

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/options/command_line.hpp"
#include "common/options/parse_number.hpp"

namespace gvd::app {

/// Adds an option that takes one number in `range`, in any locale. `Target` is T or std::optional<T>.
/// The type that --help shows is N or NUMBER.
template <class T, class Target>
void add_number(CommandLine& line, OptionText option, Target& target, const Range<T>& range) {
  constexpr bool kWhole = std::numeric_limits<T>::is_integer;
  option.type = std::string(kWhole ? "N" : "NUMBER");
  option.kind = kWhole ? ValueKind::whole : ValueKind::number;
  line.add_value(option, [&target, range](const std::string& text) -> std::optional<std::string> {
    const std::optional<T> value = parse_number_in(text, range);
    if (!value) return fmt::format("'{}' is not {}", text, range.text);
    target = *value;
    return std::nullopt;
  });
}

/// The names of the values of a choice.
template <class T>
using Choices = std::vector<std::pair<std::string, T>>;

/// Adds an option that takes one of a few names. `Target` is T or std::optional<T>.
/// The type that --help shows is the list of names.
template <class T, class Target>
void add_choice(CommandLine& line, OptionText option, Target& target, const Choices<T>& choices) {
  option.type.clear();
  for (const auto& [name, value] : choices) option.type += (option.type.empty() ? "" : "|") + name;
  line.add_value(option, [&target, choices, listed = option.type](const std::string& text) {
    for (const auto& [name, value] : choices) {
      if (text != name) continue;
      target = value;
      return std::optional<std::string>();
    }
    return std::optional<std::string>(fmt::format("'{}' is none of {}", text, listed));
  });
}

/// Adds an option whose text is stored as it is.
inline void add_text(CommandLine& line, const OptionText& option, std::string& target) {
  line.add_value(option, [&target](const std::string& text) {
    target = text;
    return std::optional<std::string>();
  });
}

/// Adds an option that names a file, which an empty text does not. `kind`: what is named, for messages.
inline void add_file(CommandLine& line, const OptionText& option, std::string& target,
                     const std::string& kind = "file") {
  line.add_value(option, [&target, kind](const std::string& text) {
    if (text.empty()) return std::optional<std::string>("the name is empty; name a " + kind);
    target = text;
    return std::optional<std::string>();
  });
}

}  // namespace gvd::app
