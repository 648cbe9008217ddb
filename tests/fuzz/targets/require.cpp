#include "fuzz/targets/require.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace gvd::fuzz {
namespace {

/// Characters. A message quotes tokens of the input, and must shorten them.
constexpr std::size_t kLongestMessage = 400;

}  // namespace

void fail(std::string_view what) {
  fmt::print(stderr, "finding: {}\n", what);
  std::abort();
}

void require_proper(const Error& error, std::initializer_list<ErrorCode> codes) {
  const std::string message = error.what();
  require(std::find(codes.begin(), codes.end(), error.code()) != codes.end(),
          fmt::format("the error code {} is none of the expected: {}", static_cast<int>(error.code()), message));
  require(message.size() >= 15 && message.size() <= kLongestMessage,
          fmt::format("a message of {} characters: {}", message.size(), message));
  const auto is_control = [](char c) { return (c >= 0 && c < ' ') || c == 127; };
  require(std::none_of(message.begin(), message.end(), is_control),
          fmt::format("a message with control characters: {}", message));
  require(message.back() != '.' || message.ends_with("..."), fmt::format("a message with a full stop: {}", message));
}

void fail_exception(const std::exception& error) {
  fail(fmt::format("an exception that is no Error: {}: {}", typeid(error).name(), error.what()));
}

}  // namespace gvd::fuzz
