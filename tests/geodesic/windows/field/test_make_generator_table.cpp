#include <cstdint>
#include <vector>

#include "geodesic/windows/field/make_generator_table.hpp"
#include "geodesic/windows/propagation/propagate_windows.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/propagate.hpp"

namespace gvd::test_make_generator_table {

TEST_CASE("the table of exact distances has each vertex's nearest generator, and no distance that is too short") {
  const Mesh mesh = test::make_bumpy_sphere(3, 2);
  const std::vector<VertexId> generators{VertexId(0), VertexId(100), VertexId(200)};
  const WindowField field = test::propagate(mesh, generators, KeepWindows::near_bisectors);
  const GeneratorTable table = make_generator_table(mesh, field);
  std::vector<WindowField> alone;
  for (const VertexId g : generators) alone.push_back(test::propagate(mesh, {g}));
  for (int i = 0; i < mesh.vertex_count(); ++i) {
    const VertexId v(i);
    const std::int32_t nearest = table.find(v, field.label[v]);
    REQUIRE(nearest >= 0);
    CHECK(table.distance(nearest).distance == Approx(field.distance[v]).epsilon(1e-12).margin(1e-14));
    table.for_each(
        v, [&](const VertexDistance& d) { CHECK(d.distance >= alone[d.generator.index()].distance[v] * (1 - 1e-12)); });
  }
  for (int f = 0; f < mesh.face_count(); ++f) CHECK(table.reached(FaceId(f)));
}

}  // namespace gvd::test_make_generator_table
