#include <cmath>

#include "diffusion/heat_field.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_heat_field {

using namespace paper;

/// The heat of one generator, times the lumped areas of the vertices.
double total_heat(const Mesh& mesh, const std::vector<double>& heat) {
  double sum = 0;
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (const VertexId v : mesh.vertices(FaceId(f))) sum += mesh.area(FaceId(f)) / 3 * heat[v.index()];
  }
  return sum;
}

TEST_CASE("no heat is lost, and every generator sends the same") {
  for (const auto& [name, mesh] : test::small_family()) {
    if (name.find("thin") != std::string::npos) continue;  // obtuse angles make negative heat, which is left out
    INFO(name);
    const double square = mesh.mean_edge_length() * mesh.mean_edge_length();
    const HeatField field = compute_heat(mesh, {VertexId(0), VertexId(mesh.vertex_count() / 2)}, square);
    for (const auto& heat : field.heat) {
      CHECK(total_heat(mesh, heat) / square == Approx(HeatField::kScale).epsilon(1e-6));
    }
  }
}

TEST_CASE("heat does not depend on the mesh's unit") {
  const Mesh mesh = test::make_sphere(2);
  std::vector<Vec3> positions = mesh.positions();
  std::vector<std::array<VertexId, 3>> faces;
  for (Vec3& p : positions) p *= 1e-6;
  for (int f = 0; f < mesh.face_count(); ++f) faces.push_back(mesh.vertices(FaceId(f)));
  const Mesh small(positions, faces);
  const auto heat_of = [](const Mesh& m) {
    return compute_heat(m, {VertexId(0)}, m.mean_edge_length() * m.mean_edge_length()).heat[0];
  };
  const auto large_heat = heat_of(mesh), small_heat = heat_of(small);
  for (std::size_t v = 0; v < large_heat.size(); ++v) CHECK(small_heat[v] == Approx(large_heat[v]).epsilon(1e-9));
}

TEST_CASE("on a flat strip heat falls by one factor from vertex to vertex") {
  const Mesh mesh = test::make_grid(60, 1);
  const HeatField field = compute_heat(mesh, {VertexId(0)}, mesh.mean_edge_length() * mesh.mean_edge_length());
  const auto& heat = field.heat[0];
  const double factor = heat[31] / heat[30];
  CHECK(factor < 1);
  for (std::size_t v = 20; v < 50; ++v) CHECK(heat[v + 1] / heat[v] == Approx(factor).epsilon(1e-6));
}

}  // namespace gvd::test_heat_field
