// The rounding of images and distances, against the plane in long double: the table at kSameImage in window.hpp.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "geodesic/windows/window_filters.hpp"
#include "support/catch.hpp"
#include "support/propagate.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_window_rounding {

/// Squares along both axes. A straight path from the origin crosses at most twice as many faces as the larger number.
constexpr int kAlong = 500, kAcross = 60;

/// A flat strip of rectangles with a diagonal, `width` wide and one long, jittered by up to `shift`; vertex 0 is the
/// origin.
Mesh make_strip(double shift, double width) {
  const Mesh squares = test::make_jittered_grid(kAlong, kAcross, shift, 5);
  std::vector<Vec3> positions = squares.positions();
  for (Vec3& p : positions) p.y() *= width;
  std::vector<std::array<VertexId, 3>> faces;
  for (int f = 0; f < squares.face_count(); ++f) faces.push_back(squares.vertices(FaceId(f)));
  return Mesh(std::move(positions), std::move(faces));
}

/// The largest error of distances over at most so many faces, as a fraction of the distance.
long double distance_error(const Mesh& strip, const WindowField& field, int faces) {
  long double worst = 0;
  for (int v = 1; v < strip.vertex_count(); ++v) {
    if (2 * std::max(v % (kAlong + 1), v / (kAlong + 1)) > faces) continue;
    const Vec3& p = strip.position(VertexId(v));
    const long double exact = std::hypot(static_cast<long double>(p.x()), static_cast<long double>(p.y()));
    worst = std::max(worst, std::abs(field.distance[VertexId(v)] - exact) / exact);
  }
  return worst;
}

/// The error of a window's image, as a fraction of the image's distance from the origin of the window's frame.
long double image_error(const Mesh& strip, const Window& w) {
  const bool is_inner = strip.twin(w.halfedge).valid();
  const Vec3& start = strip.position(is_inner ? strip.from(w.halfedge) : strip.to(w.halfedge));
  const Vec3& end = strip.position(is_inner ? strip.to(w.halfedge) : strip.from(w.halfedge));
  const long double x = start.x(), y = start.y(), along_x = end.x() - x, along_y = end.y() - y;
  const long double length = std::hypot(along_x, along_y), distance = std::hypot(x, y);
  const long double image_x = -(x * along_x + y * along_y) / length;
  const long double depth = std::abs(x * along_y - y * along_x) / length;
  return std::hypot(w.x - image_x, w.depth - depth) / distance;
}

long double largest_image_error(const Mesh& strip, const WindowField& field) {
  long double worst = 0;
  for (int f = 0; f < strip.face_count(); ++f) {
    field.windows.for_each(FaceId(f), [&](const Window& w) {
      const bool is_at_origin = strip.from(w.halfedge) == VertexId(0) || strip.to(w.halfedge) == VertexId(0);
      if (!is_at_origin) worst = std::max(worst, image_error(strip, w));
    });
  }
  return worst;
}

TEST_CASE("rounding moves images over 1000 faces by less than a quarter of kSameImage, and lengths by less than ties") {
  for (const auto& [shift, width] : {std::pair(0.0, 1.0), std::pair(0.0, 0.13), std::pair(0.0, 0.37),
                                     std::pair(0.2, 1.0), std::pair(0.2, 0.05), std::pair(0.2, 20.0)}) {
    INFO("jitter " << shift << ", rectangles " << width << " wide");
    const Mesh strip = make_strip(shift, width);
    const WindowField field = test::propagate(strip, {VertexId(0)}, KeepWindows::all);
    CHECK(distance_error(strip, field, 2 * kAlong) < 0.75L * kDropClearance);
    CHECK(distance_error(strip, field, 200) < kSameLength);
    CHECK(distance_error(strip, field, 40) < kLengthRounding);
    CHECK(largest_image_error(strip, field) < 0.25L * kSameImage);
  }
}

}  // namespace gvd::test_window_rounding
