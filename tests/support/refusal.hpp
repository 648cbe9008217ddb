#pragma once

#include <functional>
#include <string>

#include "gvd/error.hpp"
#include "support/catch.hpp"

namespace gvd::test {

/// The message of the error that `work` throws, which has this code and is one line.
inline std::string refusal(const std::function<void()>& work, ErrorCode code = ErrorCode::invalid_option) {
  try {
    work();
  } catch (const Error& error) {
    CHECK(error.code() == code);
    CHECK(std::string(error.what()).find('\n') == std::string::npos);
    return error.what();
  }
  return "nothing was refused";
}

}  // namespace gvd::test
