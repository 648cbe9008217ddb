#pragma once

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "diagram/graph/crossings.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// A connected set of faces where three or more generators may compete. Bisectors are traced up to its rim, the edges
/// with a face outside, and grow through its inside (section 4.3).
struct Gap {
  std::vector<FaceId> faces;  ///< ascending
  bool contains(FaceId f) const { return std::binary_search(faces.begin(), faces.end(), f); }
};

/// Whether a halfedge of one of the gap's faces lies on its rim.
inline bool is_rim(const Mesh& mesh, const Gap& gap, HalfedgeId h) {
  const HalfedgeId twin = mesh.twin(h);
  return twin.valid() && !gap.contains(Mesh::face(twin));
}

/// A node of the graph that grows in a gap: a crossing on the rim, a new crossing, or a branch point.
struct GapNode {
  enum class Kind { rim, crossing, branch };
  Kind kind;
  CrossingId rim;                ///< for a rim node: the existing crossing
  Crossing crossing{};           ///< for a new crossing, inside the gap or on the mesh's boundary
  FaceId face;                   ///< for a branch point: its face
  std::array<double, 3> bary{};  ///< for a branch point: barycentric coordinates in `face`
  double distance = 0;           ///< for a branch point: predicted distance to its generators, mesh units
};

/// A straight part of a bisector inside one face of the gap.
struct GapArc {
  FaceId face;
  int begin, end;           ///< indices of nodes
  GeneratorId left, right;  ///< cells on the two sides, on the way from begin to end
};

/// The bisectors inside one gap.
struct GrownGap {
  std::vector<GapNode> nodes;
  std::vector<GapArc> arcs;
  std::vector<std::pair<VertexId, GeneratorId>> labels;  ///< new labels of vertices that changed cells, ascending
};

/// A gap and the bisectors that grew in it. It may consist of several gaps that met, with faces between and around
/// them.
struct ClosedGap {
  Gap gap;
  GrownGap grown;
  std::vector<int> merged;  ///< indices of the gaps that it closes, ascending
};

}  // namespace gvd
