#include "common/run/outcome.hpp"

#include <fmt/format.h>

#include <exception>
#include <new>
#include <optional>
#include <string_view>
#include <system_error>

#include "common/memory/heap_count.hpp"
#include "common/memory/memory_limit.hpp"
#include "common/run/name_options.hpp"
#include "gvd/error.hpp"

namespace gvd::app {
namespace {

struct CodeWords {
  ErrorCode code;
  ExitCode exit_code;
  const char* words;
};

constexpr CodeWords kNoValidResult{ErrorCode::no_valid_result, kNoResult, "no valid result"};
constexpr CodeWords kCodes[]{{ErrorCode::invalid_option, kUsage, "usage"},
                             {ErrorCode::unreadable_input, kUnreadableInput, "unreadable input"},
                             {ErrorCode::precondition, kPreconditionNotMet, "precondition not met"},
                             kNoValidResult,
                             {ErrorCode::unwritable_output, kNotWritten, "not written"},
                             {ErrorCode::interrupted, kInterrupted, "interrupted"},
                             {ErrorCode::reader_gone, kReaderGone, "reader gone"}};

const CodeWords& words_of(ErrorCode code) {
  for (const CodeWords& each : kCodes) {
    if (each.code == code) return each;
  }
  return kNoValidResult;
}

Outcome out_of_memory(std::optional<std::int64_t> in_use = {}) {
  return {kNoResult, describe_shortage(in_use), "out of memory"};
}

/// oneTBB throws a std::runtime_error with the name of the function that failed; std::thread a std::system_error.
bool tells_of_threads(const std::exception& error) {
  const auto* const system = dynamic_cast<const std::system_error*>(&error);
  return (system != nullptr && system->code() == std::errc::resource_unavailable_try_again) ||
         std::string_view(error.what()).find("pthread_create") != std::string_view::npos;
}

Outcome describe_exception(const std::exception& error) {
  if (tells_of_threads(error)) {
    return {kNoResult,
            "a thread could not be started: the system allows no more threads, or no memory for one; use --threads 1",
            "no thread"};
  }
  return {kNoResult, fmt::format("unexpected: {}; please report it", error.what()), "unexpected error"};
}

}  // namespace

Outcome describe_failure(const std::exception_ptr& failure) {
  if (!failure && refused_request()) return out_of_memory();  // not even the exception had memory
  if (!failure) return {kNoResult, "unexpected: ended without an exception; please report it", "unexpected error"};
  try {
    std::rethrow_exception(failure);
  } catch (const Error& error) {
    const CodeWords& words = words_of(error.code());
    const bool gone = error.code() == ErrorCode::reader_gone;
    return {words.exit_code, gone ? "" : name_options(error.what()), words.words};
  } catch (const MemoryLimitPassed& passed) {
    return out_of_memory(passed.in_use());
  } catch (const std::bad_alloc&) {
    return out_of_memory();
  } catch (const std::exception& error) {
    return describe_exception(error);
  } catch (...) {
    return {kNoResult, "unexpected: an exception of an unknown type; please report it", "unexpected error"};
  }
}

Outcome run_guarded(const std::function<void()>& work) {
  std::exception_ptr failure;
  try {
    work();
    return {};
  } catch (...) {
    failure = std::current_exception();
  }
  lift_heap_limit_here();  // the message needs some
  return describe_failure(failure);
}

}  // namespace gvd::app
