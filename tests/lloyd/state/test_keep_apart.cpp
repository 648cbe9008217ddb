#include "state/keep_apart.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"

namespace gvd::test_keep_apart {

/// The point x of a strip along the x axis.
SurfacePoint at(double x) { return edge_point(Mesh::halfedge(FaceId(2 * static_cast<int>(x)), 0), x - std::floor(x)); }

Mesh make_strip() { return test::make_grid(8, 1); }

TEST_CASE("keep apart: no points, one point, and points that did not move") {
  const Mesh mesh = make_strip();
  std::vector<SurfacePoint> none;
  CHECK(keep_apart(mesh, {}, 1, none) == 0);
  std::vector<SurfacePoint> one{at(0.5)};
  CHECK(keep_apart(mesh, {at(3.5)}, 1, one) == 0);
  CHECK(one[0] == at(0.5));
  const std::vector<SurfacePoint> from{at(0.5), at(0.75)};
  std::vector<SurfacePoint> to = from;
  CHECK(keep_apart(mesh, from, 1, to) == 0);  // closer than the gap, but neither has moved
  CHECK(to == from);
}

TEST_CASE("keep apart: both of two points that collide go back, or the one that has moved") {
  const Mesh mesh = make_strip();
  const std::vector<SurfacePoint> from{at(1.5), at(3.5), at(6.5)};
  std::vector<SurfacePoint> to{at(2.5), at(2.55), at(5.5)};
  CHECK(keep_apart(mesh, from, 0.1, to) == 2);
  CHECK(to == std::vector<SurfacePoint>{from[0], from[1], at(5.5)});
  to = {at(1.5), at(1.55), at(6.5)};
  CHECK(keep_apart(mesh, from, 0.1, to) == 1);
  CHECK(to == from);
}

TEST_CASE("keep apart: a point that goes back may push the next one back") {
  const Mesh mesh = make_strip();
  // Each of the points has moved to where the one before it comes from; the last one collides with a fixed one.
  const std::vector<SurfacePoint> from{at(0.5), at(1.5), at(2.5), at(3.5), at(7.5)};
  std::vector<SurfacePoint> to{at(1.5), at(2.5), at(3.5), at(7.45), at(7.5)};
  CHECK(keep_apart(mesh, from, 0.1, to) == 4);
  CHECK(to == from);
}

TEST_CASE("keep apart: after it, no moved point is within the gap of another one") {
  const Mesh mesh = test::make_sphere(2);
  test::Random random(7);
  const auto draw = [&] {
    const double u = random.real(0.05, 0.9), v = (1 - u) * random.real(0.05, 0.95);
    return make_surface_point(FaceId(random.below(mesh.face_count())), {u, v, 1 - u - v});
  };
  for (const double gap : {0.05, 0.2}) {
    std::vector<SurfacePoint> from, to;
    while (from.size() < 40) {
      const SurfacePoint p = draw();
      const auto near = [&](const SurfacePoint& q) { return (position(mesh, p) - position(mesh, q)).norm() <= gap; };
      if (std::none_of(from.begin(), from.end(), near)) from.push_back(p);
    }
    for (std::size_t i = 0; i < from.size(); ++i) to.push_back(draw());
    const std::vector<SurfacePoint> wanted = to;
    const std::int32_t undone = keep_apart(mesh, from, gap, to);
    std::int32_t at_start = 0;
    for (std::size_t i = 0; i < to.size(); ++i) {
      CHECK((to[i] == wanted[i] || to[i] == from[i]));
      at_start += to[i] == from[i];
      for (std::size_t k = 0; k < i; ++k) CHECK((position(mesh, to[i]) - position(mesh, to[k])).norm() > gap);
    }
    CHECK(undone == at_start);
  }
}

}  // namespace gvd::test_keep_apart
