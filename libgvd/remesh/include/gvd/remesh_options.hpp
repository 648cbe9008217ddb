#pragma once

#include "gvd/option_list.hpp"
#include "gvd/remesh_surface.hpp"

namespace gvd {

/// Describes how generators are relaxed and how their remesh is built and placed. The options must outlive the list.
void describe(OptionList& list, SurfaceRemeshOptions& options);

}  // namespace gvd
