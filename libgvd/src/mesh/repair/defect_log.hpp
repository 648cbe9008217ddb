#pragma once

#include <cstdint>
#include <string>

#include "gvd/error.hpp"
#include "gvd/soup.hpp"

namespace gvd {

/// Throws Error{precondition}. `element` is the polygon or the vertex of the soup that the message names.
[[noreturn]] inline void refuse_soup(const std::string& message, std::int64_t element) {
  throw Error(ErrorCode::precondition, message, element);
}

/// Collects the defects of a soup in a report. Under DefectPolicy::error it throws on the first one.
class DefectLog {
 public:
  explicit DefectLog(DefectPolicy policy) : policy_(policy) {}

  /// Adds a defect. `what` says what is wrong and where it occurs first, and `action` says how it was repaired. Does
  /// nothing if `count` is 0.
  void add(DefectKind kind, std::int64_t count, std::int64_t first, const std::string& what, const std::string& action);
  /// Adds a change that the user asked for, which no policy refuses. Does nothing if `count` is 0.
  void add_asked(DefectKind kind, std::int64_t count, std::int64_t first, const std::string& message);
  DefectPolicy policy() const { return policy_; }
  DefectReport& report() { return report_; }

 private:
  DefectPolicy policy_;
  DefectReport report_;
};

}  // namespace gvd
