#pragma once

#include <cstdint>
#include <vector>

#include "geodesic/windows/window_field.hpp"
#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

/// The windows that are kept after they have been carried across their face.
enum class KeepWindows {
  none,
  near_bisectors,  ///< windows on the edges of faces that a bisector can cross
  all,
};

struct PropagationOptions {
  KeepWindows keep = KeepWindows::all;
  /// Distance at which each generator starts, mesh units, >= 0: an additive weight, or a tie break. If empty, 0 for
  /// all.
  std::vector<double> offsets;
  int threads = 0;  ///< number of threads, >= 1, or 0 for one per core
  /// Number of faces of a partition, >= 1; there are at most 64 partitions, and one thread works on a partition at a
  /// time. Smaller partitions exchange more windows; with larger ones, threads wait longer at the end of a round.
  /// Distances are exact for any value; the number of windows on edges between partitions may differ.
  std::int32_t partition_faces = 8192;
  /// Record where all paths leave their generators. This needs KeepWindows::all.
  bool departures = false;
  /// Points farther than this from all generators are not reached; mesh units, >= 0. Distances up to it are exact, and
  /// every window that holds one of them is kept. The propagation goes on for a few edges beyond it.
  double max_distance = kInfinity;
};

/// Exact distances from the nearest of the generators, by propagation of windows.
///
/// A window is a bundle of straight paths through the same faces (window.hpp). It is carried across one face after the
/// other and split at the corners (face_crossing.hpp). If it contains a straight path to a corner, it offers the corner
/// a distance. Paths can bend at a saddle or a reflex boundary vertex: these send windows themselves
/// (pseudo_sources.hpp). Windows that hold no shortest path are dropped (window_filters.hpp). Windows of different
/// generators need not be trimmed against each other: a shortest path stays in the closed cell of its generator, so the
/// windows that matter are never dropped.
///
/// Source: Chen and Han (1990), with the filters of Xin and Wang (2009), for many generators at once.
/// Inputs: the generators' vertices, each once.
/// Error: 1e-14 of the distance over 200 faces, 6e-14 over 1000 (kSameImage in window.hpp), 1e-13 with thin faces.
/// Properties: (1) every distance is the length of a path; (2) none is shorter; (3) the order in which windows are
/// propagated changes distances by rounding at most, and it is the same for any number of threads
/// (propagation_rounds.hpp); (4) if generators tie at a vertex, within 2e-14 of the distance, its label is the first of
/// them, however the mesh is partitioned. Cost: O(windows); about 5 to 16 a face on curved meshes, 2 where flat parts
/// are refined. Memory: 130 to 350 bytes a face on such meshes, 460 and more with a single generator. If all faces are
/// needles, paths tie in many places, and there may be up to O(faces) windows a face.
WindowField propagate_windows(const Mesh& mesh, const std::vector<VertexId>& generators,
                              const PropagationOptions& options, const Progress& progress);
/// The same from the generators of a working mesh, which may be curves. Throws Error{invalid_option} if curves have
/// offsets, or departures are to be recorded.
WindowField propagate_windows(const WorkingMesh& working, const PropagationOptions& options, const Progress& progress);

}  // namespace gvd
