// Suggests the name that the user may have meant by a misspelt one.

#include <algorithm>
#include <string_view>

#include "gvd/option_text.hpp"
#include "gvd/text.hpp"

namespace gvd {
namespace {

/// The fewest letters of a name that count as its beginning: shorter beginnings would fit too many options. Names in
/// capitals, which are no options, need only one letter.
std::size_t least_beginning(const std::string& name) { return name.front() >= 'A' && name.front() <= 'Z' ? 1 : 3; }

/// Reduces a text such as "--Sampling=random" to "sampling".
std::string bare_name(const std::string& text) {
  const std::size_t first = text.find_first_not_of('-');
  return first == text.npos ? "" : to_lower(text.substr(first, text.find('=') - first));
}

/// Whether `typed` consists of beginnings of words of `name`, in order and including the first word, with or without
/// dashes: "outdir" or "out-d" for "output-dir".
bool abbreviates(std::string_view typed, std::string_view name) {
  if (typed.empty()) return true;
  if (!name.empty() && typed.front() == name.front() && abbreviates(typed.substr(1), name.substr(1))) return true;
  const std::size_t dash = name.find('-');
  if (dash == name.npos || dash + 1 == name.size()) return false;
  const std::string_view next = name.substr(dash + 1), rest = typed.substr(typed.front() == '-' ? 1 : 0);
  return !rest.empty() && rest.front() == next.front() && abbreviates(rest.substr(1), next.substr(1));
}

/// The least number of insertions, deletions, replacements and swaps of neighbours that turn one text into the other
/// (the distance of Damerau and Levenshtein, with no letter changed twice).
std::size_t count_edits(const std::string& from, const std::string& to) {
  std::vector<std::size_t> before, last, now(to.size() + 1);
  for (std::size_t j = 0; j <= to.size(); ++j) now[j] = j;
  for (std::size_t i = 1; i <= from.size(); ++i) {
    before = std::move(last);
    last = now;
    now[0] = i;
    for (std::size_t j = 1; j <= to.size(); ++j) {
      now[j] = std::min({last[j] + 1, now[j - 1] + 1, last[j - 1] + (from[i - 1] != to[j - 1])});
      const bool swapped = i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1];
      if (swapped) now[j] = std::min(now[j], before[j - 2] + 1);
    }
  }
  return now[to.size()];
}

}  // namespace

std::optional<std::string> suggest_name(const std::string& wrong, const std::vector<std::string>& names) {
  const std::string typed = bare_name(wrong);
  std::optional<std::string> nearest, longer;
  std::size_t least = std::max<std::size_t>(1, typed.size() / 3) + 1;
  for (const std::string& name : names) {
    const std::string bare = bare_name(name);
    // At least this many letters have to be inserted or deleted.
    const std::size_t fewest = std::max(typed.size(), bare.size()) - std::min(typed.size(), bare.size());
    const std::size_t edits = fewest < least ? count_edits(typed, bare) : least;
    // An option of a single letter is not suggested for a misspelt name.
    if (edits < least && (bare.size() > 1 || edits == 0)) {
      least = edits;
      nearest = name;
    }
    const bool begins = typed.size() >= least_beginning(name) && typed.size() <= bare.size() &&
                        typed.front() == bare.front() && abbreviates(typed, bare);
    if (begins && (!longer || name.size() < longer->size())) longer = name;
  }
  return longer && least > 0 ? longer : nearest;
}

}  // namespace gvd
