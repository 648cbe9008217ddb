#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gvd/observer.hpp"

namespace gvd::test {

/// Keeps what an operation tells.
struct Recorder : Observer {
  Recorder() { threads = 1; }
  bool progress(std::string_view, double) override { return !cancels; }
  void enter(std::string_view step) override {
    steps.emplace_back(step);
    ++depth;
  }
  void leave() override { --depth; }
  void note(const std::string& text) override { notes.push_back(text); }
  void detail(const std::string& text) override { details.push_back(text); }

  bool has(std::string_view step) const {
    for (const std::string& one : steps) {
      if (one == step) return true;
    }
    return false;
  }

  bool cancels = false;
  int depth = 0;
  std::vector<std::string> steps, notes, details;
};

}  // namespace gvd::test
