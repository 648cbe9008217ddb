// Euler's number and boundary loops of single components.
#include "mesh/component_topology.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_component_topology {

std::vector<ComponentTopology> topologies(const Mesh& mesh) {
  return compute_topologies(mesh, compute_face_components(mesh));
}

TEST_CASE("component topology: a triangle is a disc with one loop") {
  CHECK(topologies(test::make_triangle()) == std::vector<ComponentTopology>{{1, 1}});
}

TEST_CASE("component topology: sphere, torus, ring, and a surface with three handles") {
  CHECK(topologies(test::make_sphere(2)) == std::vector<ComponentTopology>{{2, 0}});
  CHECK(topologies(test::make_torus(12, 8)) == std::vector<ComponentTopology>{{0, 0}});
  CHECK(topologies(test::make_ring(12, 2)) == std::vector<ComponentTopology>{{0, 2}});
  CHECK(topologies(test::make_genus3(2)) == std::vector<ComponentTopology>{{-4, 0}});
}

TEST_CASE("component topology: each component for itself, and in sum the summary's") {
  const Mesh mesh = test::make_two_components();
  const auto found = topologies(mesh);
  REQUIRE(found.size() == 2);
  const MeshSummary whole = compute_mesh_summary(mesh);
  CHECK(found[0].euler_characteristic + found[1].euler_characteristic == whole.euler_characteristic);
  CHECK(found[0].boundary_loops + found[1].boundary_loops == whole.boundary_loops);
}

TEST_CASE("genus: twice the handles of closed surfaces, and those with holes") {
  CHECK(twice_genus(1, 0, 2) == 0);   // a sphere
  CHECK(twice_genus(1, 1, 1) == 0);   // a disc
  CHECK(twice_genus(1, 0, 0) == 2);   // a torus
  CHECK(twice_genus(1, 0, -4) == 6);  // three handles
  CHECK(twice_genus(2, 0, 4) == 0);   // two spheres
}

}  // namespace gvd::test_component_topology
