#include "judge.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

using namespace gvd;
using namespace gvd::paper;

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
