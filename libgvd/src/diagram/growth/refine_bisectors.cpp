// Refinement of the rough bisectors by unfolding (section 4.2).
//
// In a face with one bisector, both generators are unfolded into the face's plane, where the bisector is straight. Each
// face can thus estimate where the bisector crosses its edges. In general, the two faces of an edge disagree; welding
// takes the mean of their estimates, which the paper calls consistency enforcement.
// Invariant: along an edge, crossings keep their order, and kCrossingGap from each other, so that no cell vanishes from
// the edge.
#include "diagram/growth/refine_bisectors.hpp"

#include <algorithm>

#include "geodesic/face_layout.hpp"
#include "geodesic/marching/unfold.hpp"
#include "gvd/diagram_steps.hpp"

namespace gvd {
namespace {

/// Number of faces between two reports of progress.
constexpr std::size_t kRefineStride = 1 << 12;

}  // namespace

void estimate_crossings(const Mesh& mesh, const Crossings& crossings, const std::vector<BoundaryCrossing>& ends,
                        const FaceImages& images, std::vector<CrossingEstimate>& estimates) {
  for (const BoundaryCrossing& c : ends) {
    const double t =
        equidistant_parameter(images.corner[c.corner], images.corner[(c.corner + 1) % 3], images.first, images.second);
    if (!(t > 0 && t < 1)) continue;
    const bool along = mesh.halfedge(crossings[c.id].edge) == Mesh::halfedge(images.face, c.corner);
    estimates.push_back({c.id, along ? t : 1 - t});
  }
}

std::vector<CrossingEstimate> refine_bisectors(const GrowthInput& input, const Crossings& crossings,
                                               const Progress& progress) {
  const Mesh& mesh = input.mesh();
  std::vector<CrossingEstimate> estimates;
  std::vector<BoundaryCrossing> boundary;
  const std::vector<FaceId> faces = crossed_faces(mesh, crossings);
  for (std::size_t k = 0; k < faces.size(); ++k) {
    if (k % kRefineStride == 0) report_progress(progress, steps::kRefinement, double(k) / double(faces.size()));
    const FaceId f = faces[k];
    boundary_crossings(mesh, crossings, f, boundary);
    if (boundary.size() != 2) continue;
    const auto corner = FaceLayout(mesh, f).corner;
    const Vec2 next = unfold_generator(corner, corner_distances(input, f, boundary[0].next));
    const Vec2 previous = unfold_generator(corner, corner_distances(input, f, boundary[0].previous));
    estimate_crossings(mesh, crossings, boundary, {f, corner, next, previous}, estimates);
  }
  return estimates;
}

void weld_crossings(const std::vector<CrossingEstimate>& estimates, Crossings& crossings) {
  struct Mean {
    double sum = 0;
    int count = 0;
  };
  IdVector<CrossingId, Mean> means(crossings.size());
  for (const CrossingEstimate& e : estimates) {
    means[e.crossing].sum += e.t;
    ++means[e.crossing].count;
  }
  std::vector<Crossing>& items = crossings.items();
  for (std::size_t i = 0; i < items.size(); ++i) {
    const Mean& mean = means[CrossingId(i)];
    if (mean.count == 0) continue;
    const bool follows = i > 0 && items[i - 1].edge == items[i].edge;
    const bool leads = i + 1 < items.size() && items[i + 1].edge == items[i].edge;
    const double low = (follows ? items[i - 1].t : 0) + kCrossingGap;
    const double high = (leads ? items[i + 1].t : 1) - kCrossingGap;
    if (low < high) items[i].t = std::clamp(mean.sum / mean.count, low, high);
  }
}

}  // namespace gvd
