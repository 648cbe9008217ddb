#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "gvd/generator_list.hpp"
#include "mesh/coincidence.hpp"

namespace gvd {
namespace {

using Cube = std::array<std::int64_t, 3>;

bool share_vertex(const Mesh& mesh, FaceId f, FaceId g) {
  const auto &a = mesh.vertices(f), &b = mesh.vertices(g);
  return std::any_of(a.begin(), a.end(), [&](VertexId v) { return std::find(b.begin(), b.end(), v) != b.end(); });
}

/// The points so far, in cubes with the tolerance as side: closer points lie in the same cube or in adjacent ones.
class Grid {
 public:
  Grid(const Mesh& mesh, double tolerance) : mesh_(mesh), tolerance_(tolerance) {
    if (mesh.vertex_count() > 0) origin_ = mesh.position(VertexId(0));
  }

  /// Returns the smallest index of an earlier point that coincides with this one. Without one, inserts the point and
  /// returns its own index.
  std::int32_t insert(const SurfacePoint& point, std::int32_t index) {
    const Vec3 location = position(mesh_, point);
    const Cube centre = cube(location);
    std::int32_t first = index;
    for (int i = 0; i < 27; ++i) {
      const Cube near{centre[0] + i % 3 - 1, centre[1] + i / 3 % 3 - 1, centre[2] + i / 9 - 1};
      const auto found = cubes_.find(near);
      if (found == cubes_.end()) continue;
      for (const Entry& other : found->second) {
        const bool close =
            (other.location - location).norm() <= tolerance_ && share_vertex(mesh_, other.face, point.face);
        if (close) first = std::min(first, other.index);
      }
    }
    if (first == index) cubes_[centre].push_back({location, point.face, index});
    return first;
  }

 private:
  struct Entry {
    Vec3 location;
    FaceId face;
    std::int32_t index;
  };

  Cube cube(const Vec3& location) const {
    const Vec3 scaled = (location - origin_) / tolerance_;
    return {std::llround(scaled.x()), std::llround(scaled.y()), std::llround(scaled.z())};
  }

  const Mesh& mesh_;
  double tolerance_;
  Vec3 origin_ = Vec3::Zero();
  std::map<Cube, std::vector<Entry>> cubes_;
};

}  // namespace

std::vector<std::int32_t> find_coincident(const Mesh& mesh, const std::vector<SurfacePoint>& points) {
  Grid grid(mesh, std::max(coincidence(mesh), std::numeric_limits<double>::denorm_min()));
  std::vector<std::int32_t> first;
  first.reserve(points.size());
  for (const SurfacePoint& point : points) {
    first.push_back(grid.insert(canonical(mesh, point), static_cast<std::int32_t>(first.size())));
  }
  return first;
}

}  // namespace gvd
