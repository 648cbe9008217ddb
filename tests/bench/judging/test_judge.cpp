#include <cmath>

#include "judging/judge.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_judge {

using namespace paper;

TEST_CASE("the judge counts each wrong label, and forgives ties") {
  const Mesh mesh = test::make_grid(4, 2);
  const std::vector<SurfacePoint> generators{vertex_point(mesh, VertexId(5)), vertex_point(mesh, VertexId(9))};
  Diagram diagram = compute_diagram(mesh, generators);
  const Judge judge(mesh, generators);
  CHECK(judge.judge(diagram).wrong_labels == 0);
  CHECK(judge.judge(diagram).labelled == 15);
  CHECK(judge.judge(diagram).error.error_integral < 1e-9);
  const VertexId on_bisector(7), at_first(5), at_second(9);
  diagram.vertex_label[on_bisector] = GeneratorId(1);
  CHECK(judge.judge(diagram).wrong_labels == 0);
  diagram.vertex_label[at_first] = GeneratorId(1);
  diagram.vertex_label[at_second] = GeneratorId();
  CHECK(judge.judge(diagram).wrong_labels == 2);
}

TEST_CASE("the distances of fields are those of the plane on a flat mesh") {
  const Mesh mesh = test::make_grid(3, 3);
  const DistanceQuery query{vertex_point(mesh, VertexId(0)), {vertex_point(mesh, VertexId(15))}};
  CHECK(compute_field_distances(mesh, {query})[0][0] == Approx(std::sqrt(18.0)));
}

TEST_CASE("vertices that nothing reaches are not judged") {
  const Mesh mesh = test::make_two_components();
  const std::vector<SurfacePoint> generators{vertex_point(mesh, VertexId(0))};
  const Judgement found = Judge(mesh, generators).judge(compute_diagram(mesh, generators));
  CHECK(found.labelled < mesh.vertex_count());
  CHECK(found.wrong_labels == 0);
}

TEST_CASE("distances on the part that paths can visit are those of the whole mesh") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const ExactField field(mesh, {vertex_point(mesh, VertexId(0))});
    DistanceQuery query{vertex_point(mesh, VertexId(0)), {}};
    for (int f = 0; f < mesh.face_count(); f += 7)
      query.points.push_back(make_surface_point(FaceId(f), {0.2, 0.5, 0.3}));
    const std::vector<double> found = compute_field_distances(mesh, {query})[0];
    for (std::size_t i = 0; i < found.size(); ++i) {
      const double expected = field.nearest(query.points[i]).distance;
      if (std::isfinite(expected)) CHECK(found[i] == Approx(expected).epsilon(1e-12));
      if (!std::isfinite(expected)) CHECK(std::isinf(found[i]));
    }
  }
}

}  // namespace gvd::test_judge
