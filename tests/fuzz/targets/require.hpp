#pragma once

#include <cstdint>
#include <exception>
#include <initializer_list>
#include <string_view>
#include <typeinfo>

#include "gvd/error.hpp"

namespace gvd::fuzz {

/// Prints what is wrong and aborts: libFuzzer then keeps the input as a finding.
[[noreturn]] void fail(std::string_view what);

inline void require(bool holds, std::string_view what) {
  if (!holds) fail(what);
}

/// Fails unless the code is one of `codes` and the message is one printable line of moderate length, as Error promises.
void require_proper(const Error& error, std::initializer_list<ErrorCode> codes);

/// Fails because of an exception that is no Error.
[[noreturn]] void fail_exception(const std::exception& error);

/// Whether a step ends without an Error. Fails where the Error is not proper or of another code, and at any other
/// exception.
template <class Step>
bool attempt(std::initializer_list<ErrorCode> codes, const Step& step) {
  try {
    step();
    return true;
  } catch (const Error& error) {
    require_proper(error, codes);
  } catch (const std::exception& error) {
    fail_exception(error);
  }
  return false;
}

}  // namespace gvd::fuzz
