#include "keeps_topology.hpp"

#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

/// A vertex with more faces is not walked round. Without this limit, smoothing round the tip of a cone with n faces
/// would take O(n^2).
constexpr int kLongestFan = 256;

/// Whether test(face) holds for every face round v.
template <class Test>
bool all_faces_round(const Mesh& mesh, VertexId v, Test test) {
  const HalfedgeId start = mesh.halfedge(v);
  HalfedgeId h = start;
  for (int i = 0; i < kLongestFan; ++i) {
    if (!test(Mesh::face(h))) return false;
    h = next_outgoing(mesh, h);
    if (!h.valid() || h == start) return true;
  }
  return false;
}

/// The sides of a face behind which a label lies.
struct Sides {
  int count = 0;
  int with = 0;     // the last side with the label
  int without = 0;  // the last side without it
};

}  // namespace

// The open region of a label is its faces, the edges between them, and the vertices that only they surround. A
// face that leaves changes F - E + V by -1 + 1 if it has one neighbour of its label. With two neighbours it changes by
// -1 + 2 - 1, if the corner between the two sides was inside. In every other case the region falls apart or a hole
// opens. Joining is the same backwards.
bool keeps_topology(const Mesh& mesh, const IdVector<FaceId, GeneratorId>& label, FaceId f, GeneratorId to) {
  const GeneratorId from = label[f];
  const auto find_sides = [&](GeneratorId g) {
    Sides sides;
    for (int corner = 0; corner < 3; ++corner) {
      const HalfedgeId twin = mesh.twin(Mesh::halfedge(f, corner));
      const bool same = twin.valid() && label[Mesh::face(twin)] == g;
      sides.count += same;
      (same ? sides.with : sides.without) = corner;
    }
    return sides;
  };
  const auto opposite = [&](int side) { return mesh.opposite(Mesh::halfedge(f, side)); };
  const Sides left = find_sides(from), joined = find_sides(to);
  if (left.count == 0 || left.count == 3 || joined.count == 0) return false;
  if (left.count == 2) {
    const VertexId v = opposite(left.without);
    if (mesh.is_boundary(v) || !all_faces_round(mesh, v, [&](FaceId g) { return label[g] == from; })) return false;
  }
  if (joined.count == 1) {
    return all_faces_round(mesh, opposite(joined.with), [&](FaceId g) { return label[g] != to; });
  }
  const VertexId v = opposite(joined.without);
  return !mesh.is_boundary(v) && all_faces_round(mesh, v, [&](FaceId g) { return g == f || label[g] == to; });
}

}  // namespace gvd
