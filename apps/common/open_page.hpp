#pragma once

#include <string>

namespace gvd::app {

/// Shows a file in the user's browser: by the first program of $BROWSER that is there (names between colons, with %s
/// for the file or the file behind them), or else by xdg-open, or on macOS by open. Waits half a second at most, since
/// a program that can't show it ends soon with an exit code. Returns what went wrong; empty where nothing did so far.
std::string open_page(const std::string& file);

}  // namespace gvd::app
