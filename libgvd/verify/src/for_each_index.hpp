#pragma once

#include <cstddef>
#include <functional>

namespace gvd {

/// Runs body(i) for every i in [0, count), on up to `threads` threads (0: all cores), in no stated order.
///
/// After each of its own, the calling thread alone runs report(fraction done); what `report` throws ends the run.
/// Where bodies throw, all are run and the exception of the least index is thrown: the same for any thread count.
void for_each_index(std::size_t count, int threads, const std::function<void(std::size_t)>& body,
                    const std::function<void(double)>& report);

}  // namespace gvd
