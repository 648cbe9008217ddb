#include <cmath>

#include "bench/comparisons.hpp"
#include "comparators.hpp"
#include "diffusion.hpp"
#include "judge.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/refusal.hpp"

namespace gvd::test_diffusion {

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

TEST_CASE("diffusion gives most vertices of a sphere their nearest generator, and not all points") {
  const Mesh mesh = test::make_sphere(4);
  const auto generators = test::vertex_points(mesh, 14, 1, 180);
  const Judge judge(mesh, generators);
  const Comparison found = compute_diffusion(mesh, generators);
  const Judgement judgement = judge.judge(found.diagram);
  CHECK(double(judgement.wrong_labels) < 0.1 * double(judgement.labelled));
  CHECK(judgement.error.error_integral > 10 * judge.judge(compute_diagram(mesh, generators)).error.error_integral);
  CHECK(found.faults.unreached_vertices == 0);
  CHECK(found.faults.islands == 0);
  CHECK(found.faults.open_ends == 0);
}

TEST_CASE("mirrored generators have mirrored cells") {
  const Mesh mesh = test::make_ring(32, 8);
  const std::vector<SurfacePoint> generators{vertex_point(mesh, VertexId(0)), vertex_point(mesh, VertexId(16 * 9))};
  const Comparison found = compute_diffusion(mesh, generators);
  CHECK(found.diagram.cells[GeneratorId(0)].area == Approx(found.diagram.cells[GeneratorId(1)].area).epsilon(1e-6));
}

TEST_CASE("the pieces of diffusion cover every mesh") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const Comparison found = compute_diffusion(mesh, test::random_generators(mesh, 12, 5));
    const double area = test::mesh_area(mesh);
    CHECK(test::total_area(found.diagram) + found.faults.unowned_area == Approx(area).epsilon(1e-9));
    CHECK(found.faults.lost_generators == 0);
  }
}

TEST_CASE("a deeper cap refines the cells where three meet, and changes them little") {
  const Mesh mesh = test::make_sphere(3);
  const auto generators = test::vertex_points(mesh, 8, 1, 80);
  const Comparison coarse = compute_diffusion(mesh, generators, {1, 0}),
                   fine = compute_diffusion(mesh, generators, {1, 8});
  CHECK(coarse.faults.forced_faces > 0);
  CHECK(fine.faults.forced_faces > 0);
  CHECK(fine.diagram.pieces.size() > coarse.diagram.pieces.size());
  for (int g = 0; g < 8; ++g) {
    const double before = coarse.diagram.cells[GeneratorId(g)].area;
    CHECK(fine.diagram.cells[GeneratorId(g)].area == Approx(before).epsilon(0.02));
    CHECK(fine.diagram.cells[GeneratorId(g)].area != before);
  }
}

TEST_CASE("where heat underflows vertices have no label, and are counted") {
  const Mesh mesh = test::make_grid(400, 1);
  const std::vector<SurfacePoint> generators{vertex_point(mesh, VertexId(0)), vertex_point(mesh, VertexId(1))};
  const Comparison found = compute_diffusion(mesh, generators, {1e-4, 5});
  CHECK(found.faults.unreached_vertices > 100);
  CHECK(found.faults.unowned_area > 50);
  CHECK(compute_diffusion(mesh, generators, {1, 5}).faults.unreached_vertices == 0);
}

TEST_CASE("options out of their range are refused") {
  const Mesh mesh = test::make_sphere(1);
  const std::vector<SurfacePoint> generators{vertex_point(mesh, VertexId(0))};
  const auto message = [&](double factor, int splits) {
    return test::refusal([&] { compute_diffusion(mesh, generators, {factor, splits}); });
  };
  CHECK(message(0, 5).find("time factor") != std::string::npos);
  CHECK(message(1, 13).find("splits") != std::string::npos);
  CHECK(message(1, 12) == "nothing was refused");
}

}  // namespace gvd::test_diffusion
