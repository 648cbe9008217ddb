#pragma once

#include <vector>

#include "geodesic/window_field.hpp"
#include "geodesic/window_retention.hpp"
#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"

namespace gvd {

struct PropagationOptions {
  KeepWindows keep = KeepWindows::all;
  double bucket_width = 0.8;  ///< of the queue, in mean edge lengths
};

WindowField propagate_windows(const Mesh& mesh, const std::vector<VertexId>& generators,
                              const PropagationOptions& options, const Progress& progress);

}  // namespace gvd
