#pragma once

#include <vector>

#include "comparator.hpp"

namespace gvd::paper {

struct WindowVoronoiOptions {
  /// Whether each generator's windows are propagated over the whole mesh, without pruning by the other generators: what
  /// an algorithm like MMP does. The diagram is the same; time and memory are not.
  bool unpruned = false;
};

/// The geodesic Voronoi diagram from exact windows, with straight segments.
///
/// Source: C. Xu, Y.-J. Liu, Q. Sun, J. Li, Y. He, Polyline-sourced geodesic Voronoi diagrams on triangle meshes, 2014:
///   [27] in the paper, section 5.3.
/// All windows that enter a triangle are kept, and with its corners they are weighted points in its plane. Crossings
/// lie where their lower envelope changes generators along an edge. `WeightedFace` joins them in the triangle.
/// `field_ms`: the window propagation; `diagram_ms`: crossings and pieces. Generators may lie anywhere: they become
/// vertices first, which counts for neither. Faults: forced faces. One thread.
Comparison compute_window_voronoi(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                                  const WindowVoronoiOptions& options = {});

}  // namespace gvd::paper
