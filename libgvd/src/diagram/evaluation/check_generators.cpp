#include "diagram/evaluation/check_generators.hpp"

#include <algorithm>

#include "base/barycentric.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {
namespace {

/// How far a generator may lie outside its cell, relative to the bounding box's diagonal: rounding, and a thousand
/// times the distance within which a generator is taken for a vertex.
constexpr double kDistanceTolerance = 1e-9;

class GeneratorCheck {
 public:
  GeneratorCheck(const Mesh& mesh, const Diagram& diagram) : mesh_(mesh), diagram_(diagram) {}

  /// A point on an edge belongs to the faces on both sides. In a face without area other points lie at the same
  /// position, and the cell may reach the point only from the other side.
  bool is_in_cell(const SurfacePoint& p, GeneratorId g) const {
    if (p.kind() == SurfacePoint::Kind::vertex) return diagram_.vertex_label[vertex(mesh_, p)] == g;
    if (is_in_cell_within_face(p, g)) return true;
    if (p.kind() != SurfacePoint::Kind::edge) return false;
    const HalfedgeId h = halfedge(p), twin = mesh_.twin(h);
    return twin.valid() && is_in_cell_within_face(edge_point(twin, p.bary[Mesh::corner(h)]), g);
  }

 private:
  bool is_in_cell_within_face(const SurfacePoint& p, GeneratorId g) const {
    if (diagram_.face_label[p.face].valid()) return diagram_.face_label[p.face] == g;
    const auto pieces = std::equal_range(diagram_.pieces.begin(), diagram_.pieces.end(), FacePiece{p.face, g, {}},
                                         [](const FacePiece& a, const FacePiece& b) { return a.face < b.face; });
    return std::any_of(pieces.first, pieces.second,
                       [&](const FacePiece& piece) { return piece.generator == g && contains(piece, p); });
  }

  /// Whether a piece contains a point of its face, within the tolerance.
  bool contains(const FacePiece& piece, const SurfacePoint& p) const {
    const Vec3 at = position(mesh_, p);
    bool inside = false;
    for (std::size_t i = 0, n = piece.corners.size(); i < n; ++i) {
      const Bary &a = piece.corners[i], &b = piece.corners[(i + 1) % n];
      const Vec3 from = position(mesh_, {piece.face, a}), along = position(mesh_, {piece.face, b}) - from;
      const double t = along.squaredNorm() > 0 ? std::clamp((at - from).dot(along) / along.squaredNorm(), 0.0, 1.0) : 0;
      if ((from + t * along - at).norm() <= kDistanceTolerance * mesh_.bbox_diagonal()) return true;
      // Count the sides that the ray from p along the second coordinate crosses.
      if ((a[2] > p.bary[2]) == (b[2] > p.bary[2])) continue;
      const double where = a[1] + (b[1] - a[1]) * (p.bary[2] - a[2]) / (b[2] - a[2]);
      if (where > p.bary[1]) inside = !inside;
    }
    return inside;
  }

  const Mesh& mesh_;
  const Diagram& diagram_;
};

}  // namespace

void check_generators(const Mesh& mesh, const Diagram& diagram, Violations& violations) {
  const GeneratorCheck check(mesh, diagram);
  for (std::size_t i = 0; i < diagram.generators.size(); ++i) {
    const GeneratorId g(i);
    if (!check.is_in_cell(diagram.generators[i], g)) violations.add(1, "generator", i, "lies outside its cell");
    // An area of 0 is sound: the faces around the generator may have none.
    if (!(diagram.cells[g].area >= 0)) violations.add(1, "cell", i, "its area is negative or not a number");
  }
}

}  // namespace gvd
