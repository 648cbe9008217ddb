#pragma once

#include "gvd/diagram.hpp"
#include "gvd/option_list.hpp"

namespace gvd {

/// The heading of the options that say how something is computed.
inline constexpr const char* kComputingGroup = "Computing";

/// Describes the method, the chord tolerance and the front. The options must outlive the list.
void describe(OptionList& list, DiagramOptions& options);

/// Describes a number of threads, 0 for all cores.
void describe_threads(OptionList& list, int& threads);

/// Stores what the options leave to their method.
void resolve(DiagramOptions& options);

}  // namespace gvd
