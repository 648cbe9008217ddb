// Components that are left out because they are small.
#include <cmath>
#include <vector>

#include "gvd/drop_small_components.hpp"
#include "gvd/error.hpp"
#include "support/catch.hpp"

namespace gvd::test_drop_small_components {

using Catch::Matchers::Contains;

/// A square of side 4 between two triangles with legs of 1 and 2. Polygons: triangle, square, triangle; and an unused
/// vertex at the front.
PolygonSoup make_parts() {
  PolygonSoup soup;
  soup.positions = {{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 3}, {4, 0, 3},
                    {4, 4, 3}, {0, 4, 3}, {0, 0, 5}, {2, 0, 5}, {0, 2, 5}};
  soup.corners = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
  soup.first_corner = {0, 3, 7, 10};
  return soup;
}

TEST_CASE("components with a smaller diagonal are left out, and the others keep their places in the input") {
  CheckedMesh checked = build_mesh(make_parts());
  drop_small_components(checked, {1.5});
  CHECK(checked.mesh.face_count() == 3);
  CHECK(checked.input_polygon.raw() == std::vector<std::int32_t>{1, 1, 2});
  CHECK(checked.input_vertex.raw() == std::vector<std::int32_t>{4, 5, 6, 7, 8, 9, 10});
  for (const VertexId v : checked.mesh.vertices()) {
    CHECK(checked.mesh_vertex[std::size_t(checked.input_vertex[v])] == v);
  }
  for (const int gone : {0, 1, 2, 3}) CHECK_FALSE(checked.mesh_vertex[std::size_t(gone)].valid());
  CHECK(checked.defects.count(DefectKind::dropped_components) == 1);
  CHECK(checked.defects.messages.back() ==
        "1 component is smaller than 1.5, first the one of face 0: left out, with 2.7 % of the area");
}

TEST_CASE("a component of exactly the size stays, and a fraction is one of the whole mesh's diagonal") {
  const double diagonal = build_mesh(make_parts()).mesh.bbox_diagonal();
  CheckedMesh same = build_mesh(make_parts());
  drop_small_components(same, {std::sqrt(2.0)});
  CHECK(same.mesh.face_count() == 4);
  CHECK_THAT(same.defects.messages.back(), Contains("no component is smaller than 1.41421: none is left out"));
  CheckedMesh one = build_mesh(make_parts());
  drop_small_components(one, {3 / diagonal, true});
  CHECK(one.mesh.face_count() == 2);
  CHECK(one.defects.count(DefectKind::dropped_components) == 2);
}

TEST_CASE("texture coordinates and materials of what is left stay with their faces") {
  PolygonSoup soup = make_parts();
  for (int i = 0; i < 10; ++i) soup.appearance.texture.push_back({double(i), 0});
  soup.appearance.materials = {"a", "b", "c"};
  soup.appearance.material = {0, 1, 2};
  CheckedMesh checked = build_mesh(soup);
  drop_small_components(checked, {3});
  CHECK(checked.appearance.material == std::vector<std::int32_t>{1, 1});
  REQUIRE(checked.appearance.texture.size() == 6);
  for (const FaceId f : checked.mesh.faces()) {
    for (int i = 0; i < 3; ++i) {
      const std::int32_t vertex = checked.input_vertex[checked.mesh.vertices(f)[i]];
      CHECK(checked.appearance.texture[std::size_t(3 * f.value() + i)][0] == vertex - 1);
    }
  }
}

TEST_CASE("where all components are smaller, the error names the largest") {
  CheckedMesh checked = build_mesh(make_parts());
  try {
    drop_small_components(checked, {6});
    FAIL("nothing is left");
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::precondition);
    CHECK_THAT(error.what(), Contains("all components are smaller than 6, the largest one 5.65685 across"));
  }
}

}  // namespace gvd::test_drop_small_components
