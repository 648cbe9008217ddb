#pragma once

#include <optional>
#include <string>
#include <vector>

namespace gvd::app {

/// The name that `wrong` most likely stands for, or nothing. Dashes in front, a value behind "=", and capitals don't
/// count.
///
/// The same name, or the shortest one whose words begin with those of `wrong`, where that has three letters, or
/// one for "INPUT": "--out-d" or "--outdir" for "--output-dir". Else
/// the name that takes the fewest insertions, deletions, replacements and swaps of neighbours, if there is at most one
/// for each three letters of `wrong`, or one in all. The first of equals is taken. Cost: O(letters) for each letter of
/// each name.
std::optional<std::string> suggest_name(const std::string& wrong, const std::vector<std::string>& names);

}  // namespace gvd::app
