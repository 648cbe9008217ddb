#pragma once

#include <cstdint>
#include <vector>

#include "geodesic/windows/window_field.hpp"
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
  /// Distance at which each generator starts, mesh units, >= 0: an additive weight, or a tie break. Empty: 0 for all.
  std::vector<double> offsets;
  int threads = 0;  ///< that work at the same time, >= 1; 0: as many as there are cores
  /// The mesh is cut into parts of about so many faces, >= 1, that one thread works on at a time; 64 parts at the most.
  /// With fewer faces more windows cross from part to part, with more the last part of a round is waited for longer.
  /// Distances are exact with any; windows on edges between parts may come in another number.
  std::int32_t partition_faces = 8192;
};

/// Exact distances from the nearest of the generators, by propagation of windows.
///
/// A window is a bundle of straight paths through the same faces (window.hpp). It is carried across one face after the
/// other and split at the corners; where it meets a corner it offers a distance. A corner that paths can bend at, a
/// saddle or a reflex boundary vertex, sends windows itself (vertex_fan.hpp). What can hold no shortest path is dropped
/// (window_filters.hpp). Windows of different generators need not be trimmed against each other: a shortest path stays
/// in the closed cell of its generator, so the ones that matter are never dropped.
///
/// Source: Chen and Han (1990), with the filters of Xin and Wang (2009), for many generators at once.
/// Inputs: the generators' vertices, each once. Error: 1e-14 of the distance on ordinary meshes, 1e-13 with slivers.
/// Properties: (1) every distance is the length of a path; (2) none is shorter; (3) the order in which windows are
/// taken changes no distance, but for rounding, and it is the same for any number of threads (propagation_rounds.hpp); (4)
/// of generators that tie at a vertex, to 2e-14 of the distance, the first one is its label, in whatever parts the mesh
/// is cut. Cost: O(windows); about 5 to 16 a face on curved meshes, 2 where flat parts are refined. Memory: 130 to 350
/// bytes a face on such meshes, 460 and more with a single generator (docs/notes/performance.md). Where all faces are
/// needles, paths tie all over: up to O(faces) windows a face were seen.
WindowField propagate_windows(const Mesh& mesh, const std::vector<VertexId>& generators,
                              const PropagationOptions& options, const Progress& progress);

}  // namespace gvd
