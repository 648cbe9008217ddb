#include <algorithm>
#include <iterator>

#include "mesh/point_views.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_point_views {

TEST_CASE("views: one in each face that contains the point, ascending, all at the point's position") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    for (const SurfacePoint& p : test::random_generators(mesh, 60, 8)) {
      const std::vector<SurfacePoint> views = find_views(mesh, p);
      std::vector<FaceId> faces = faces_around(mesh, p);
      std::sort(faces.begin(), faces.end());
      REQUIRE(views.size() == faces.size());
      for (std::size_t i = 0; i < views.size(); ++i) {
        REQUIRE(views[i].face == faces[i]);
        REQUIRE(views[i].kind() == p.kind());
        REQUIRE((position(mesh, views[i]) - position(mesh, p)).norm() <= 1e-14 * mesh.bbox_diagonal());
        REQUIRE(canonical(mesh, views[i]) == canonical(mesh, p));
      }
      REQUIRE(canonical(mesh, p) == views.front());
    }
  }
}

TEST_CASE("views: the point across an edge has the same weights, and comes back") {
  const Mesh mesh = test::make_grid(2, 2);
  for (int i = 0; i < mesh.halfedge_count(); ++i) {
    const HalfedgeId h(i);
    const SurfacePoint p = edge_point(h, 0.375);
    const auto across = find_view_across(mesh, p);
    REQUIRE(across.has_value() == mesh.twin(h).valid());
    if (!across) continue;
    CHECK(halfedge(*across) == mesh.twin(h));
    CHECK(*across == edge_point(mesh.twin(h), 0.625));
    CHECK(*find_view_across(mesh, *across) == p);
  }
}

TEST_CASE("views: two points have a common one exactly where a face contains both, and it is the first") {
  const Mesh mesh = test::make_torus(8, 6);
  const std::vector<SurfacePoint> points = test::random_generators(mesh, 60, 4);
  for (const SurfacePoint& a : points) {
    for (const SurfacePoint& b : points) {
      std::vector<FaceId> in_a = faces_around(mesh, a), in_b = faces_around(mesh, b), both;
      std::sort(in_a.begin(), in_a.end());
      std::sort(in_b.begin(), in_b.end());
      std::set_intersection(in_a.begin(), in_a.end(), in_b.begin(), in_b.end(), std::back_inserter(both));
      const auto common = find_common_view(mesh, a, b);
      REQUIRE(common.has_value() == !both.empty());
      if (!common) continue;
      REQUIRE(common->first.face == both.front());
      REQUIRE(common->second.face == both.front());
      REQUIRE(canonical(mesh, common->first) == canonical(mesh, a));
      REQUIRE(canonical(mesh, common->second) == canonical(mesh, b));
    }
  }
}

}  // namespace gvd::test_point_views
