#include "diagram/growth/accept_branch.hpp"

#include <algorithm>
#include <array>

#include "geodesic/face_layout.hpp"

namespace gvd {
namespace {

/// Largest difference of two distances that count as equal, in multiples of the longest side of the face. The paper
/// names none. Distances of marching are off by some hundredths of a side.
constexpr double kEquidistance = 0.25;

/// Distances to the left, the middle and the right generator.
std::array<double, 3> distances_at(const GrowingEnd& first, const GrowingEnd& second, const Vec2& point) {
  return {(point - first.left_image).norm(),
          0.5 * ((point - first.right_image).norm() + (point - second.left_image).norm()),
          (point - second.right_image).norm()};
}

}  // namespace

double branch_distance(const GrowingEnd& first, const GrowingEnd& second, const Vec2& point) {
  const auto d = distances_at(first, second, point);
  return (d[0] + d[1] + d[2]) / 3;
}

bool accept_branch(const GrowthInput& input, const GrowingEnd& first, const GrowingEnd& second, const Vec2& point) {
  const auto plane = FaceLayout(input.mesh(), first.face).corner;
  const double longest =
      std::max({(plane[1] - plane[0]).norm(), (plane[2] - plane[1]).norm(), (plane[0] - plane[2]).norm()});
  const double tolerance = kEquidistance * longest;
  const auto d = distances_at(first, second, point);
  const double least = *std::min_element(d.begin(), d.end());
  if (*std::max_element(d.begin(), d.end()) - least > tolerance) return false;
  bool is_nearest = true;
  input.table.for_each(first.face, [&](const TableEntry& entry) {
    const GeneratorId g = entry.generator;
    if (g == first.left || g == first.right || g == second.right) return;
    const Vec2 image = unfold_generator(plane, input.table.corner_distances(entry));
    is_nearest = is_nearest && (point - image).norm() > least - tolerance;
  });
  return is_nearest;
}

}  // namespace gvd
