#pragma once

#include <cstddef>
#include <string>

namespace gvd::test {

std::ptrdiff_t line_count(const std::string& text);

/// Runs a command and requires an error: this exit code, nothing on standard output, and one line on standard error
/// that holds `part`.
void require_error(const std::string& name, const std::string& arguments, int code, const std::string& part);

}  // namespace gvd::test
