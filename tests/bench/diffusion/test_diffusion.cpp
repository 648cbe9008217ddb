#include "bench/comparisons.hpp"
#include "diffusion/diffusion.hpp"
#include "judging/judge.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/refusal.hpp"

namespace gvd::test_diffusion {

using namespace paper;

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
