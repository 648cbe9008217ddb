// Check that cells partition the surface: property (2) of `check_diagram`.
//
// The label or the pieces of every reached face have to cover it once, and the area of a cell is the sum of theirs.
// Vertices have the label of all faces and pieces at them, so that cells fit each other across edges.
// Invariant: faces and pieces are visited in one order, ascending by face, and areas are summed in that order.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/barycentric.hpp"
#include "diagram/check_parts.hpp"

namespace gvd {
namespace {

/// Relative tolerance of areas: they are sums of up to a million rounded terms.
constexpr double kAreaTolerance = 1e-9;

/// Change of a triangle's area by rounding of a corner's coordinates, relative to the largest coordinate times the
/// longest edge: one or two rounding steps a corner. It dominates for thin faces far from the origin.
constexpr double kCornerRounding = 1e-15;

class PartitionCheck {
 public:
  PartitionCheck(const Mesh& mesh, const Diagram& diagram, const ReachedFaces& reached, Violations& violations)
      : mesh_(mesh),
        diagram_(diagram),
        reached_(reached),
        violations_(violations),
        cell_area_(diagram.cells.size(), 0.0) {}

  void run() {
    check_areas();
    check_vertex_labels();
  }

 private:
  void check_areas() {
    double total = 0;
    for (const FaceId f : mesh_.faces()) {
      const double share = covered_share(f), expected = reached_.contains(f) ? 1 : 0;
      if (std::abs(share - expected) > kAreaTolerance) {
        violations_.add(2, "face", f.index(),
                        fmt::format("its label and pieces cover {:f} of its area instead of {}", share, int(expected)));
      }
      total += expected * mesh_.area(f);
    }
    const double tolerance = kAreaTolerance * total + area_rounding();
    for (const Cell& c : diagram_.cells) {
      if (std::abs(c.area - cell_area_[c.generator]) <= tolerance) continue;
      violations_.add(2, "cell", c.generator.index(), "its area is not that of its faces and pieces");
    }
    if (next_ < diagram_.pieces.size()) violations_.add(2, "piece", next_, "pieces are not sorted by face");
  }

  /// Computes the share of f's area that its label or its pieces cover, and credits it to the cells. Faces come in
  /// order.
  double covered_share(FaceId f) {
    double share = diagram_.face_label[f].valid() ? 1 : 0;
    const bool cut = next_ < diagram_.pieces.size() && diagram_.pieces[next_].face == f;
    if (cut && share > 0) violations_.add(2, "face", f.index(), "has a label and pieces");
    if (share > 0) cell_area_[diagram_.face_label[f]] += mesh_.area(f);
    for (; next_ < diagram_.pieces.size() && diagram_.pieces[next_].face == f; ++next_) {
      const double piece_share = area_share(diagram_.pieces[next_].corners);
      if (piece_share < -kAreaTolerance) violations_.add(2, "piece", next_, "its area is negative");
      share += piece_share;
      cell_area_[diagram_.pieces[next_].generator] += piece_share * mesh_.area(f);
    }
    return share;
  }

  /// The rounding error of the areas of all faces and pieces, whose corners are rounded independently.
  double area_rounding() const {
    double edges = 0;
    const auto longest = [&](FaceId f) {
      const auto& length = mesh_.shape(f).length;
      return *std::max_element(length.begin(), length.end());
    };
    for (const FaceId f : mesh_.faces()) edges += longest(f);
    for (const FacePiece& piece : diagram_.pieces) edges += longest(piece.face);
    return kCornerRounding * mesh_.largest_coordinate() * edges;
  }

  void check_vertex_labels() {
    for (const FaceId f : mesh_.faces()) {
      const GeneratorId g = diagram_.face_label[f];
      if (!g.valid()) continue;
      for (const VertexId v : mesh_.vertices(f)) check_vertex_label(v, g);
    }
    for (const FacePiece& piece : diagram_.pieces) {
      for (const std::array<double, 3>& corner : piece.corners) {
        for (int k = 0; k < 3; ++k) {
          // Exactly the vertex, since a crossing may be as close to it as rounding allows.
          const bool at_vertex = corner[(k + 1) % 3] == 0 && corner[(k + 2) % 3] == 0;
          if (at_vertex) check_vertex_label(mesh_.vertices(piece.face)[k], piece.generator);
        }
      }
    }
  }

  void check_vertex_label(VertexId v, GeneratorId g) {
    if (diagram_.vertex_label[v] == g) return;
    violations_.add(2, "vertex", v.index(), "its label is not that of a face or piece at it");
  }

  const Mesh& mesh_;
  const Diagram& diagram_;
  const ReachedFaces& reached_;
  Violations& violations_;
  IdVector<GeneratorId, double> cell_area_;  // area of the faces and pieces of each cell
  std::size_t next_ = 0;                     // first piece that is not yet counted
};

}  // namespace

void check_partition(const Mesh& mesh, const Diagram& diagram, const ReachedFaces& reached, Violations& violations) {
  PartitionCheck(mesh, diagram, reached, violations).run();
}

ReachedFaces::ReachedFaces(const Mesh& mesh, const std::vector<SurfacePoint>& generators)
    : component_(compute_face_components(mesh)) {
  std::int32_t count = 0;
  for (const std::int32_t c : component_) count = std::max(count, c + 1);
  has_generator_.assign(count, 0);
  for (const SurfacePoint& g : generators) has_generator_[component_[g.face]] = 1;
}

}  // namespace gvd
