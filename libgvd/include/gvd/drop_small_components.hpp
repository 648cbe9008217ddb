#pragma once

#include "gvd/option_list.hpp"
#include "gvd/soup.hpp"

namespace gvd {

/// Leaves out the components whose bounding box has a smaller diagonal than `size`, in mesh units or in diagonals of
/// the whole mesh: the screws and crumbs of an assembly.
///
/// The other components keep their order and their places in the input. The defects count the components as
/// DefectKind::dropped_components; their message has the share of the area. Where no component is so small, a message
/// says so. Throws Error{precondition} where all are. Cost: O(n).
void drop_small_components(CheckedMesh& checked, const ErrorBound& size);

}  // namespace gvd
