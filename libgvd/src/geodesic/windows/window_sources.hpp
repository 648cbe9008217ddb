#pragma once

#include <vector>

#include "base/parallel_chunks.hpp"
#include "geodesic/distance_field.hpp"
#include "geodesic/face_layout.hpp"
#include "geodesic/generator_table.hpp"
#include "geodesic/windows/window_field.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"

namespace gvd {

/// Overwrites `sources` with all sources that reach the edge of halfedge h: its two ends, then the windows from both
/// sides. Positions are measured from `from(h)`. Cost: O(windows on the two faces).
void collect_edge_sources(const Mesh& mesh, const WindowField& field, HalfedgeId h, std::vector<EdgeSource>& sources);

/// Overwrites `sources` with all sources that reach points of face f, in its layout: the windows that enter through its
/// sides, then its corners. Cost: O(windows on the face).
void collect_face_sources(const Mesh& mesh, const WindowField& field, FaceId f, const FaceLayout& layout,
                          std::vector<FaceSource>& sources);
inline void collect_face_sources(const Mesh& mesh, const WindowField& field, FaceId f,
                                 std::vector<FaceSource>& sources) {
  collect_face_sources(mesh, field, f, FaceLayout(mesh, f), sources);
}

/// Exact distances on edges and in faces, from the windows that the propagation kept near bisectors.
class WindowDistances final : public DistanceField {
 public:
  /// Both arguments must outlive this object.
  WindowDistances(const Mesh& mesh, const WindowField& field) : mesh_(mesh), field_(field) {}

  std::vector<EdgeId> contested_edges(const ParallelChunks& parallel) const override;
  void collect(EdgeId e, std::vector<EdgeSource>& sources) const override {
    collect_edge_sources(mesh_, field_, mesh_.halfedge(e), sources);
  }
  void collect(FaceId f, const FaceLayout& layout, std::vector<FaceSource>& sources) const override {
    collect_face_sources(mesh_, field_, f, layout, sources);
  }

 private:
  const Mesh& mesh_;
  const WindowField& field_;
};

/// Makes the generator tables that correspond to exact distances, as input of the paper's growth. A generator has an
/// entry in a face's table if one of its windows reaches the face, or a corner has its label. The entry's distances at
/// the corners are computed from these sources.
/// Reports the step "tables". Cost: O(n + windows).
GeneratorTable make_generator_table(const Mesh& mesh, const WindowField& field, const Progress& progress = {});

}  // namespace gvd
