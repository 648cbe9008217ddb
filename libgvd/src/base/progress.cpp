#include "gvd/progress.hpp"

#include <string>

#include "gvd/error.hpp"

namespace gvd {

void report_progress(const Progress& progress, std::string_view step, double fraction) {
  if (progress && !progress(step, fraction)) {
    throw Error(ErrorCode::interrupted, "interrupted during " + std::string(step));
  }
}

}  // namespace gvd
