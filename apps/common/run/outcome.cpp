#include "common/run/outcome.hpp"

#include <fmt/format.h>

#include <exception>
#include <new>

#include "common/run/heap_count.hpp"
#include "common/run/memory_limit.hpp"
#include "common/run/name_options.hpp"
#include "gvd/error.hpp"

namespace gvd::app {
namespace {

struct CodeWords {
  ErrorCode code;
  int exit_code;
  const char* words;
};

constexpr CodeWords kNoResult{ErrorCode::no_valid_result, 5, "no valid result"};
constexpr CodeWords kCodes[]{{ErrorCode::invalid_option, 2, "usage"},
                             {ErrorCode::unreadable_input, 3, "unreadable input"},
                             {ErrorCode::precondition, 4, "precondition not met"},
                             kNoResult,
                             {ErrorCode::unwritable_output, 6, "not written"},
                             {ErrorCode::interrupted, 130, "interrupted"},
                             {ErrorCode::reader_gone, kReaderGone, "reader gone"}};

const CodeWords& words_of(ErrorCode code) {
  for (const CodeWords& each : kCodes) {
    if (each.code == code) return each;
  }
  return kNoResult;
}

Outcome describe(const std::exception_ptr& failure) {
  try {
    std::rethrow_exception(failure);
  } catch (const Error& error) {
    const CodeWords& words = words_of(error.code());
    const bool gone = error.code() == ErrorCode::reader_gone;
    return {words.exit_code, gone ? "" : name_options(error.what()), words.words};
  } catch (const MemoryLimitPassed& passed) {
    return {kNoResult.exit_code, describe_shortage(passed.in_use()), "out of memory"};
  } catch (const std::bad_alloc&) {
    return {kNoResult.exit_code, describe_shortage(), "out of memory"};
  } catch (const std::exception& error) {
    return {kNoResult.exit_code, fmt::format("unexpected: {}; please report it", error.what()), "unexpected error"};
  }
}

}  // namespace

Outcome run_guarded(const std::function<void()>& work) {
  std::exception_ptr failure;
  try {
    work();
    return {};
  } catch (...) {
    failure = std::current_exception();
  }
  lift_heap_limit_here();  // the message needs some
  return describe(failure);
}

}  // namespace gvd::app
