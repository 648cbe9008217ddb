#include "common/options/merge_options.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gvd/error.hpp"

namespace gvd::app {
namespace {

using Given = std::vector<GivenOption>;

bool is_on(const GivenOption& given) { return is_given_as(given, split_names(given.option->text.names).front()); }

bool excludes(const GivenOption& one, const GivenOption& other) {
  const auto& excluded = one.option->text.excludes;
  return is_on(one) && std::any_of(excluded.begin(), excluded.end(),
                                   [&](const std::string& wanted) { return is_given_as(other, wanted); });
}

bool exclude_each_other(const GivenOption& one, const GivenOption& other) {
  return (excludes(one, other) && is_on(other)) || (excludes(other, one) && is_on(one));
}

bool names(const GivenOption& given, const std::string& wanted) {
  const std::vector<std::string> all = split_names(given.option->text.names);
  return std::find(all.begin(), all.end(), wanted.substr(0, wanted.find(' '))) != all.end();
}

bool excluded_by(const GivenOption& entry, const Given& line) {
  return std::any_of(line.begin(), line.end(), [&](const GivenOption& one) { return exclude_each_other(one, entry); });
}

/// A command line over a file.
struct Layers {
  const Given& line;
  const Given& file;
};

/// Whether the command line chooses something else than `wanted`, whether or not the file has it.
bool rules_out(const Layers& layers, const std::string& wanted) {
  const auto chooses_else = [&](const GivenOption& given) {
    const auto& excluded = given.option->text.excludes;
    return (names(given, wanted) && !is_given_as(given, wanted)) ||
           (is_on(given) && std::find(excluded.begin(), excluded.end(), wanted) != excluded.end());
  };
  const auto gone = [&](const GivenOption& entry) { return names(entry, wanted) && excluded_by(entry, layers.line); };
  return std::any_of(layers.line.begin(), layers.line.end(), chooses_else) ||
         std::any_of(layers.file.begin(), layers.file.end(), gone);
}

bool is_overridden(const GivenOption& entry, const Layers& layers) {
  const Given& line = layers.line;
  const auto same = [&](const GivenOption& given) { return given.option == entry.option; };
  if (std::any_of(line.begin(), line.end(), same) || excluded_by(entry, line)) return true;
  const auto& needs = entry.option->text.needs;
  return !needs.empty() &&
         std::all_of(needs.begin(), needs.end(), [&](const std::string& wanted) { return rules_out(layers, wanted); });
}

[[noreturn]] void refuse_given(const GivenOption& given, const std::string& message) {
  throw Error(ErrorCode::invalid_option, given.place.empty() ? message : given.place + ": " + message);
}

/// The option as it has to be named for the exclusion to be seen: with its value where that is what is excluded.
std::string named_in(const GivenOption& given, const GivenOption& by) {
  for (const std::string& wanted : by.option->text.excludes) {
    const std::size_t blank = wanted.find(' ');
    if (blank != wanted.npos && is_given_as(given, wanted)) return given.name + wanted.substr(blank);
  }
  return given.name;
}

void check_exclusions(const GivenOption& given, const Given& all) {
  for (const GivenOption& other : all) {
    if (&other == &given || !exclude_each_other(given, other)) continue;
    // What comes from a file is to be named with its place, and the line overrides the file: so both do, or neither.
    refuse_given(other.place.empty() ? given : other,
                 fmt::format("{} and {} exclude each other: keep one", named_in(given, other), named_in(other, given)));
  }
}

void check_needs(const GivenOption& given, const Given& all) {
  const auto& needs = given.option->text.needs;
  const bool met = std::any_of(needs.begin(), needs.end(), [&](const std::string& wanted) {
    return std::any_of(all.begin(), all.end(), [&](const GivenOption& other) { return is_given_as(other, wanted); });
  });
  if (met || needs.empty() || !is_on(given)) return;
  refuse_given(given,
               fmt::format("{0} does nothing here: add {1}, or leave {0} out", given.name, fmt::join(needs, " or ")));
}

}  // namespace

std::vector<GivenOption> merge_options(const std::vector<GivenOption>& line, const std::vector<GivenOption>& file) {
  Given merged = line;
  for (const GivenOption& entry : file) {
    if (!is_overridden(entry, {line, file})) merged.push_back(entry);
  }
  return merged;
}

void check_together(const std::vector<GivenOption>& given) {
  for (const GivenOption& one : given) {
    check_exclusions(one, given);
    check_needs(one, given);
  }
}

}  // namespace gvd::app
