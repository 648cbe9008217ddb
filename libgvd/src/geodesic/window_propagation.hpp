#pragma once

#include <vector>

#include "geodesic/window_field.hpp"
#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"

namespace gvd {

/// Which windows are kept after they have done their work.
enum class KeepWindows {
  none,
  near_bisectors,  ///< those on the edges of faces that a bisector can meet
  all,
};

struct PropagationOptions {
  KeepWindows keep = KeepWindows::all;
  double bucket_width = 0.8;  ///< of the queue, in mean edge lengths
};

WindowField propagate_windows(const Mesh& mesh, const std::vector<VertexId>& generators,
                              const PropagationOptions& options, const Progress& progress);

}  // namespace gvd
