#pragma once

#include <tbb/global_control.h>

#include <array>

namespace gvd::test {

/// Numbers of threads that have to make no difference.
inline constexpr std::array<int, 4> kThreads{1, 2, 3, 8};

/// While it lives, there are as many threads as are asked for, up to 8, however few cores there are.
class ManyThreads {
 private:
  tbb::global_control control_{tbb::global_control::max_allowed_parallelism, 8};
};

}  // namespace gvd::test
