#include <set>

#include "geodesic/generator_table.hpp"
#include "support/catch.hpp"

namespace gvd::test_generator_table {

std::set<int> generators_at(const GeneratorTable& table, VertexId v) {
  std::set<int> found;
  table.for_each(v, [&](const VertexDistance& d) { REQUIRE(found.insert(d.generator.value()).second); });
  return found;
}

TEST_CASE("an empty table has reached nothing") {
  const GeneratorTable table(2, 1);
  CHECK_FALSE(table.reached(VertexId(1)));
  CHECK_FALSE(table.reached(FaceId(0)));
  CHECK(table.find(VertexId(1), GeneratorId(0)) == -1);
  CHECK(table.find(FaceId(0), GeneratorId(0)) == -1);
  CHECK(generators_at(table, VertexId(0)).empty());
}

TEST_CASE("the first item of a vertex has the vertex's own index") {
  GeneratorTable table(3, 1);
  CHECK(table.add(VertexId(2), GeneratorId(7), 1.5, HalfedgeId(1)) == 2);
  CHECK(table.reached(VertexId(2)));
  CHECK_FALSE(table.reached(VertexId(1)));
  CHECK(table.distance(2).distance == 1.5);
  CHECK(table.distance(2).via == HalfedgeId(1));
}

TEST_CASE("many generators at two vertices are kept apart, and each is found") {
  GeneratorTable table(2, 1);
  for (int g = 0; g < 20; ++g) {
    table.add(VertexId(0), GeneratorId(g), g, HalfedgeId());
    table.add(VertexId(1), GeneratorId(2 * g), 100 + g, HalfedgeId());
  }
  for (int g = 0; g < 20; ++g) {
    CHECK(table.distance(table.find(VertexId(0), GeneratorId(g))).distance == g);
    CHECK(table.distance(table.find(VertexId(1), GeneratorId(2 * g))).distance == 100 + g);
    CHECK(table.find(VertexId(1), GeneratorId(2 * g + 1)) == -1);
  }
  CHECK(generators_at(table, VertexId(0)).size() == 20);
  CHECK(generators_at(table, VertexId(1)).size() == 20);
}

TEST_CASE("entries of a face refer to the distances at its corners") {
  GeneratorTable table(3, 2);
  std::array<std::int32_t, 3> corner{};
  for (int v = 0; v < 3; ++v) {
    table.add(VertexId(v), GeneratorId(0), 9, HalfedgeId());
    corner[v] = table.add(VertexId(v), GeneratorId(4), v, HalfedgeId());
  }
  table.add(FaceId(1), GeneratorId(0), {0, 1, 2}, 0);
  const std::int32_t index = table.add(FaceId(1), GeneratorId(4), corner, 3);
  CHECK(index == table.find(FaceId(1), GeneratorId(4)));
  CHECK(table.corner_distances(table.entry(index)) == std::array<double, 3>{0, 1, 2});
  CHECK(table.entry(index).face == FaceId(1));
  CHECK(table.entry_count() == 3);
  table.distance(corner[1]).distance = 0.5;  // shared, not copied
  CHECK(table.corner_distances(table.entry(index))[1] == 0.5);
}

}  // namespace gvd::test_generator_table
