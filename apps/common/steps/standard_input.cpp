#include "common/steps/standard_input.hpp"

#include <iostream>
#include <sstream>
#include <utility>

#include "common/run/interrupt.hpp"
#include "gvd/error.hpp"

namespace gvd::app {

std::string read_standard_input() {
  std::ostringstream bytes;
  bytes << std::cin.rdbuf();
  check_interrupt();
  if (std::cin.bad()) {
    throw Error(ErrorCode::unreadable_input, std::string(kStandardInput) + ": could not be read to its end");
  }
  return std::move(bytes).str();
}

}  // namespace gvd::app
