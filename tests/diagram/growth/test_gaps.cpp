#include <algorithm>

#include "diagram/growth/gaps.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/stages.hpp"

namespace gvd::test_gaps {

int competing(const GeneratorTable& table, FaceId f) {
  int count = 0;
  table.for_each(f, [&](const TableEntry& entry) { count += entry.dominated ? 0 : 1; });
  return count;
}

bool is_connected(const Mesh& mesh, const Gap& gap) {
  std::vector<FaceId> reached{gap.faces.front()};
  for (std::size_t i = 0; i < reached.size(); ++i) {
    for (int corner = 0; corner < 3; ++corner) {
      const HalfedgeId twin = mesh.twin(Mesh::halfedge(reached[i], corner));
      if (!twin.valid() || !gap.contains(Mesh::face(twin))) continue;
      if (std::find(reached.begin(), reached.end(), Mesh::face(twin)) == reached.end())
        reached.push_back(Mesh::face(twin));
    }
  }
  return reached.size() == gap.faces.size();
}

TEST_CASE("gaps are the connected groups of faces with three or more competing generators, on every family") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const test::Stages stages(mesh, test::random_generators(mesh, 20, 9), Front::circle);
    const std::vector<Gap> gaps = find_gaps(stages.mesh(), stages.table());
    std::vector<int> gap_of_face(static_cast<std::size_t>(stages.mesh().face_count()), -1);
    for (std::size_t g = 0; g < gaps.size(); ++g) {
      REQUIRE(std::is_sorted(gaps[g].faces.begin(), gaps[g].faces.end()));
      REQUIRE(is_connected(stages.mesh(), gaps[g]));
      if (g > 0) REQUIRE(gaps[g - 1].faces.front() < gaps[g].faces.front());
      for (const FaceId f : gaps[g].faces) {
        REQUIRE(gap_of_face[f.index()] == -1);
        gap_of_face[f.index()] = static_cast<int>(g);
      }
    }
    for (int i = 0; i < stages.mesh().face_count(); ++i) {
      const FaceId f(i);
      REQUIRE((gap_of_face[f.index()] >= 0) == (competing(stages.table(), f) >= 3));
      for (int corner = 0; corner < 3; ++corner) {  // two gaps never have an edge in common
        const HalfedgeId twin = stages.mesh().twin(Mesh::halfedge(f, corner));
        if (!twin.valid() || gap_of_face[f.index()] < 0 || gap_of_face[Mesh::face(twin).index()] < 0) continue;
        REQUIRE(gap_of_face[f.index()] == gap_of_face[Mesh::face(twin).index()]);
      }
    }
  }
}

TEST_CASE("two generators have no gap") {
  const Mesh mesh = test::make_grid(12, 9);
  const test::Stages stages(mesh, test::at_vertices(mesh, {3, 90}), Front::circle);
  CHECK(find_gaps(stages.mesh(), stages.table()).empty());
}

TEST_CASE("a gap contains its faces and no others") {
  const Gap gap{{FaceId(2), FaceId(5), FaceId(9)}};
  for (int f = 0; f < 12; ++f) CHECK(gap.contains(FaceId(f)) == (f == 2 || f == 5 || f == 9));
}

}  // namespace gvd::test_gaps
