#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "gvd/error.hpp"

namespace gvd {

/// A callback that long operations call now and then, with the name of the step and the fraction of it that is done, in
/// [0, 1]. It is called only by the thread that started the operation. If it returns false, the operation is cancelled:
/// it throws Error{interrupted} and changes nothing.
using Progress = std::function<bool(std::string_view step, double fraction)>;

/// Calls `progress` unless it is empty, and throws Error{interrupted} if it returns false.
inline void report_progress(const Progress& progress, std::string_view step, double fraction) {
  if (!progress || progress(step, fraction)) return;
  throw Error(ErrorCode::interrupted, "interrupted during " + std::string(step));
}

/// A part of a step: its work raises the step's fraction from `from` to `to`, both in [0, 1].
struct StepPart {
  std::string_view name;
  double from = 0, to = 1;
};

/// Reports the fraction of the step that is done when the share `done` of the part, in [0, 1], is done.
inline void report_progress(const Progress& progress, const StepPart& part, double done) {
  report_progress(progress, part.name, part.from + (part.to - part.from) * done);
}

}  // namespace gvd
