#pragma once

#include "gvd/diagram.hpp"
#include "gvd/option_list.hpp"

namespace gvd {

/// The heading of the options that control how something is computed.
inline constexpr const char* kComputingGroup = "Computing";

/// Adds the method, the chord tolerance and the front to a list of options. `options` must outlive the list.
void describe(OptionList& list, DiagramOptions& options);

/// Adds the number of threads to a list of options; 0 stands for all cores. `threads` must outlive the list.
void describe_threads(OptionList& list, int& threads);

/// Fills in the options that were left to the method: the front, unless the method is exact.
void resolve(DiagramOptions& options);

}  // namespace gvd
