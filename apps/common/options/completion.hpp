#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace gvd::app {

/// A script that completes the command line of `app` in a shell: bash, zsh or fish. It has every option that --help
/// lists, their values as far as the type shows them, and names of files. Without the last line break.
///
/// The type of an option is a list of alternatives, parted by "|". One with a small letter is a word, "FILE" any file,
/// "DIR" a folder. Others, such as "N", are not completed. "FILE.npy|csv" is a file with one of these extensions. INPUT
/// is a file.
/// Precondition: no word of a type, and no name, holds a blank or a character that a shell expands.
std::string make_completion(const CLI::App& app, const std::string& shell);

}  // namespace gvd::app
