#include "diagram/paper/refine_segments.hpp"

#include <array>
#include <optional>

#include "geodesic/face_layout.hpp"
#include "geodesic/marching/unfold.hpp"

namespace gvd {
namespace {

/// The corner between two edges of a face; edge i leads from corner i to the next.
std::size_t corner_between(int first_edge, int second_edge) {
  return static_cast<std::size_t>(second_edge == first_edge + 1 ? second_edge : 0);
}

class SegmentRefinement {
 public:
  SegmentRefinement(const Mesh& mesh, const MidpointDistances& midpoints, const Crossings& crossings)
      : mesh_(mesh), midpoints_(midpoints), crossings_(crossings) {}

  std::vector<CrossingEstimate> run() {
    std::vector<BoundaryCrossing> boundary;
    for (const FaceId f : crossed_faces(mesh_, crossings_)) {
      boundary_crossings(mesh_, crossings_, f, boundary);
      if (boundary.size() == 2) refine(f, boundary);
    }
    return std::move(estimates_);
  }

 private:
  struct Images {
    Vec2 at_corner, opposite;
  };

  void refine(FaceId f, const std::vector<BoundaryCrossing>& boundary) {
    const auto corner = FaceLayout(mesh_, f).corner;
    const std::size_t apex = corner_between(boundary[0].corner, boundary[1].corner);
    // The cell of the apex lies before the crossing on the edge that leaves it.
    const bool first_leaves = static_cast<std::size_t>(boundary[0].corner) == apex;
    const BoundaryCrossing& leaving = boundary[first_leaves ? 0 : 1];
    const auto images = unfold(f, corner, apex, leaving.previous, leaving.next);
    if (!images) return;
    for (const BoundaryCrossing& c : boundary) {
      const auto i = static_cast<std::size_t>(c.corner);
      const double t = equidistant_parameter(corner[i], corner[(i + 1) % 3], images->at_corner, images->opposite);
      if (!(t > 0 && t < 1)) continue;
      const bool along = mesh_.halfedge(crossings_[c.id].edge) == Mesh::halfedge(f, c.corner);
      estimates_.push_back({c.id, along ? t : 1 - t});
    }
  }

  /// Images of the apex's generator, on its side of the rough segment, and of the other one, on the other side.
  std::optional<Images> unfold(FaceId f, const std::array<Vec2, 3>& corner, std::size_t apex, GeneratorId at_apex,
                               GeneratorId other) const {
    const std::size_t next = (apex + 1) % 3, before = (apex + 2) % 3;
    const Vec2 t1 = 0.5 * (corner[apex] + corner[next]), t2 = 0.5 * (corner[before] + corner[apex]);
    const auto own = midpoints_.find(f, at_apex), others = midpoints_.find(f, other);
    if (!own || !others) return std::nullopt;
    // From t1 to t2 the apex lies on the left.
    return Images{unfold_source(t2, t1, (*own)[before], (*own)[apex]),
                  unfold_source(t1, t2, (*others)[apex], (*others)[before])};
  }

  const Mesh& mesh_;
  const MidpointDistances& midpoints_;
  const Crossings& crossings_;
  std::vector<CrossingEstimate> estimates_;
};

}  // namespace

std::vector<CrossingEstimate> refine_segments(const Mesh& mesh, const MidpointDistances& midpoints,
                                              const Crossings& crossings) {
  return SegmentRefinement(mesh, midpoints, crossings).run();
}

}  // namespace gvd
