#pragma once

#include "gvd/lloyd.hpp"
#include "gvd/option_list.hpp"
#include "gvd/relaxation_start.hpp"

namespace gvd {

/// Describes the options of a relaxation. `options` must outlive the list.
void describe(OptionList& list, LloydOptions& options);

/// Describes the constraints of a relaxation, and the copy on which it begins. `options` must outlive the list.
void describe(OptionList& list, RelaxationStartOptions& options);

/// Sets the defaults that depend on other options.
void resolve(LloydOptions& options);

}  // namespace gvd
