#pragma once

#include <functional>
#include <string_view>

namespace gvd {

/// Called now and then by long work, always from the thread that started it, whatever other threads share it: the
/// step's name and the part of it that is done, in [0, 1]. Returning false cancels: the work throws Error{interrupted}
/// and leaves no trace.
using Progress = std::function<bool(std::string_view step, double fraction)>;

/// Calls `progress` where there is one, and throws Error{interrupted} where it returns false.
void report_progress(const Progress& progress, std::string_view step, double fraction);

}  // namespace gvd
