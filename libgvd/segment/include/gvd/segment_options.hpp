#pragma once

#include "gvd/option_list.hpp"
#include "gvd/segment.hpp"

namespace gvd {

/// Describes the options for labelling faces. `options` must outlive the list.
void describe(OptionList& list, SegmentOptions& options);

}  // namespace gvd
