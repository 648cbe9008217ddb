#pragma once

#include <string>

namespace gvd::app {

/// Shows a file in the user's browser: by the first installed program of $BROWSER (names separated by colons, with %s
/// for the file, or with the file appended), otherwise by xdg-open, or on macOS by open. Waits at most half a second,
/// because a program that can't show the file soon ends with an exit code. Returns what went wrong; empty if nothing
/// has so far.
std::string open_page(const std::string& file);

}  // namespace gvd::app
