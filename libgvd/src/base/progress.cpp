#include "gvd/progress.hpp"

#include <string>

#include "gvd/error.hpp"

namespace gvd {

void report_progress(const Progress& progress, std::string_view step, double fraction) {
  if (progress && !progress(step, fraction)) {
    throw Error(ErrorCode::interrupted, "interrupted during " + std::string(step));
  }
}

void report_progress(const Progress& progress, const StepPart& part, double done) {
  report_progress(progress, part.name, part.from + (part.to - part.from) * done);
}

}  // namespace gvd
