// The distance between a part of a surface and its remesh, by samples.
#include "part_distance.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fit_vertices.hpp"
#include "gvd/closest_point.hpp"

namespace gvd {
namespace {

/// As many samples for each vertex of the remesh as the last round of a fit has.
constexpr double kComparedSamples = 16;

}  // namespace

bool PartDistance::is_within(const PartDistance& other) const { return rms <= other.rms && largest <= other.largest; }

PartDistance measure_part_distance(const Mesh& surface, const Mesh& remesh) {
  PartDistance distance;
  const double count = kComparedSamples * remesh.vertex_count();
  for (const auto& [from, to] : {std::pair(&surface, &remesh), std::pair(&remesh, &surface)}) {
    const ClosestPointTree tree(*to);
    double sum = 0, area = 0;
    NearestFace nearest;
    for (const AreaSample& sample : sample_surface(*from, count)) {
      nearest = tree.nearest_face(sample.position, nearest.face.valid() ? nearest.face : FaceId(0));
      distance.largest = std::max(distance.largest, nearest.distance);
      sum += sample.area * nearest.distance * nearest.distance;
      area += sample.area;
    }
    if (area > 0) distance.rms = std::max(distance.rms, std::sqrt(sum / area));
  }
  return distance;
}

}  // namespace gvd
