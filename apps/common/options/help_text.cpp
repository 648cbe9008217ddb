#include "common/options/help_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace gvd::app {
namespace {

constexpr std::size_t kDescriptionColumn = 26;
constexpr const char* kGeneral = "General";

/// "-n, --count N".
std::string title_of(const OptionText& option) {
  std::string title = fmt::format("{}", fmt::join(split_names(option.names), ", "));
  if (!option.type.empty()) title += fmt::format(" {}", option.type);
  return title;
}

std::string describe(const OptionText& option) {
  const std::string title = fmt::format("  {:{}}", title_of(option), kDescriptionColumn - 4);
  const bool beside = title.size() + 2 <= kDescriptionColumn;
  const std::string gap = beside ? "  " : fmt::format("\n{:{}}", "", kDescriptionColumn);
  return fmt::format("{}{}{}\n", title, gap,
                     wrap(option.description, kHelpWidth - kDescriptionColumn, kDescriptionColumn));
}

std::vector<std::string> list_groups(const std::vector<OptionText>& options) {
  std::vector<std::string> groups;
  for (const OptionText& option : options) {
    const bool known = std::find(groups.begin(), groups.end(), option.group) != groups.end();
    if (!known && !option.group.empty()) groups.push_back(option.group);
  }
  groups.emplace_back();
  return groups;
}

}  // namespace

std::string wrap(const std::string& text, std::size_t width, std::size_t indent) {
  std::istringstream words(text);
  std::string wrapped;
  std::size_t column = 0;
  for (std::string word; words >> word; column += word.size()) {
    if (column > 0 && column + 1 + word.size() > width) {
      wrapped += fmt::format("\n{:{}}", "", indent);
      column = 0;
    } else if (column > 0) {
      wrapped += ' ';
      ++column;
    }
    wrapped += word;
  }
  return wrapped;
}

std::string describe_options(const std::vector<OptionText>& options) {
  std::string text;
  for (const std::string& group : list_groups(options)) {
    text += fmt::format("\n{}:\n", group.empty() ? kGeneral : group);
    for (const OptionText& option : options) {
      if (option.group == group) text += describe(option);
    }
  }
  return text;
}

}  // namespace gvd::app
