#include "common/steps/standard_input.hpp"

#include <iostream>

#include "common/run/interrupt.hpp"
#include "gvd/error.hpp"
#include "gvd/text.hpp"

namespace gvd::app {

std::string read_standard_input() {
  std::string bytes = read_to_end(std::cin);
  check_interrupt();
  if (std::cin.bad()) {
    throw Error(ErrorCode::unreadable_input, std::string(kStandardInput) + ": could not be read to its end");
  }
  return bytes;
}

}  // namespace gvd::app
