#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/parallel_chunks.hpp"
#include "geodesic/windows/propagation/propagation_state.hpp"
#include "geodesic/windows/propagation/window_record.hpp"
#include "geodesic/windows/window_field.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"
#include "mesh/common_elements.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

/// A set of faces: flags for look-ups, and a list, so that loops don't have to visit all faces of the mesh.
struct FaceSet {
  IdVector<FaceId, std::uint8_t> contains;
  std::vector<FaceId> faces{};  ///< in the order of insertion

  explicit FaceSet(std::size_t count) : contains(count, 0) {}
  void add(FaceId f) {
    if (std::exchange(contains[f], 1) == 0) faces.push_back(f);
  }
};

/// All faces of a mesh, ascending.
FaceSet make_full_set(const Mesh& mesh);

/// Where and how to propagate. It refers to objects of the caller.
struct PropagationSite {
  PropagationState& state;         ///< state of the mesh, ready for a propagation
  const ParallelChunks& parallel;  ///< must not report progress
  const Progress& progress;
};

/// The result of a propagation of some generators, with a record of all windows that were carried.
struct RecordedWindows {
  WindowField field;
  IdVector<HalfedgeId, HalfedgeRecord> records;
};

/// Propagates all generators.
RecordedWindows propagate_all(const WorkingMesh& working, const PropagationSite& site);

/// Whether a face has, or at some time had, several labels. Call it after a propagation with the result `field`.
bool has_several_labels(const PropagationState& state, const WindowField& field, FaceId f);

/// The faces that a change of some generators makes different, and their windows after it.
struct ChangedWindows {
  FaceSet faces;            ///< faces that are new, or whose windows, corners or state have changed
  RecordedWindows windows;  ///< in `faces`, with the bits of a propagation of all generators; elsewhere unspecified
  std::int32_t propagated;  ///< number of generators that were propagated again
};

/// Finds the windows that a change alters, by propagating as few generators as possible again.
///
/// Inputs: the field and the record before the change; the state of the mesh after the change, ready for a propagation.
/// Cost: O(n) with small constants, and the propagation in the cells of the generators that take part.
ChangedWindows find_changed_windows(const GeneratorChange& change, const WindowField& field, const WindowRecord& record,
                                    const PropagationSite& site);

}  // namespace gvd
