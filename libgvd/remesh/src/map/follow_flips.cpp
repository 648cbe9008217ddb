// Takes points of a mesh to the mesh that flips of its edges lead to.
#include "map/follow_flips.hpp"

#include <algorithm>
#include <array>

namespace gvd {
namespace {

/// A point by the weights of the corners of its face.
struct Place {
  FaceId face;
  std::array<VertexId, 3> corners;
  std::array<double, 3> weights{};

  double weight(VertexId v) const {
    const auto at = std::find(corners.begin(), corners.end(), v) - corners.begin();
    return at < 3 ? weights[at] : 0;
  }
};

/// The corners of the square are, in order, `from`, `right_apex`, `to` and `left_apex`.
Place follow_flip(const EdgeFlip& flip, const Place& place) {
  const double x = place.weight(flip.to) + place.weight(flip.right_apex);
  const double y = place.weight(flip.to) + place.weight(flip.left_apex);
  const auto [left, right] = flip.after();
  if (x + y <= 1) return {flip.left, left, {1 - x - y, x, y}};
  return {flip.right, right, {1 - y, x + y - 1, 1 - x}};
}

}  // namespace

FlipFollower::FlipFollower(const Mesh& before, const Mesh& after, const std::vector<EdgeFlip>& flips)
    : before_(before), after_(after), flips_(flips), flips_of_(before.face_count()) {
  for (std::size_t i = 0; i < flips.size(); ++i) {
    flips_of_[flips[i].left].push_back(i);
    flips_of_[flips[i].right].push_back(i);
  }
}

SurfacePoint FlipFollower::follow(const SurfacePoint& point) const {
  if (point.kind() == SurfacePoint::Kind::vertex) return vertex_point(after_, vertex(before_, point));
  if (flips_of_[point.face].empty()) return point;
  Place place{point.face, before_.vertices(point.face), point.bary};
  for (std::size_t next = 0; next < flips_.size();) {
    const std::vector<std::size_t>& flips = flips_of_[place.face];
    const auto flip = std::lower_bound(flips.begin(), flips.end(), next);
    if (flip == flips.end()) break;
    place = follow_flip(flips_[*flip], place);
    next = *flip + 1;
  }
  const std::array<VertexId, 3>& corners = after_.vertices(place.face);
  return make_surface_point(place.face,
                            {std::max(0.0, place.weight(corners[0])), std::max(0.0, place.weight(corners[1])),
                             std::max(0.0, place.weight(corners[2]))});
}

}  // namespace gvd
