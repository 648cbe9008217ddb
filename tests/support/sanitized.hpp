#pragma once

#include <cstddef>
#include <initializer_list>
#include <vector>

namespace gvd::test {

// Sanitizers have an allocator of their own, and reserve more memory than there is.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kSanitized = true;
#elif defined(__has_feature)
inline constexpr bool kSanitized = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
inline constexpr bool kSanitized = false;
#endif

/// The cases of a long test. Sanitizers take ten times as long and look at what is done, not at how often: they get
/// every third case, from the first one on.
template <class T>
std::vector<T> thinned(std::initializer_list<T> cases) {
  std::vector<T> kept;
  for (std::size_t i = 0; i < cases.size(); i += kSanitized ? 3 : 1) kept.push_back(cases.begin()[i]);
  return kept;
}

}  // namespace gvd::test
