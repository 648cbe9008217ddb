#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace gvd {

/// The findings of a check, one line each: "(property) element id: what is wrong".
class Violations {
 public:
  void add(int property, const std::string& text) { lines_.push_back(fmt::format("({}) {}", property, text)); }
  void add(int property, const char* element, std::size_t id, const std::string& text) {
    lines_.push_back(fmt::format("({}) {} {}: {}", property, element, id, text));
  }

  bool empty() const { return lines_.empty(); }
  std::vector<std::string> take() { return std::move(lines_); }

 private:
  std::vector<std::string> lines_;
};

}  // namespace gvd
