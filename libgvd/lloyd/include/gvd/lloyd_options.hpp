#pragma once

#include "gvd/lloyd.hpp"
#include "gvd/option_list.hpp"
#include "gvd/relaxation_start.hpp"

namespace gvd {

/// Describes how generators are relaxed. The options must outlive the list.
void describe(OptionList& list, LloydOptions& options);

/// Describes what restricts a relaxation, and the copy that it begins on. As above.
void describe(OptionList& list, RelaxationStartOptions& options);

/// Stores the defaults that depend on other options.
void resolve(LloydOptions& options);

}  // namespace gvd
