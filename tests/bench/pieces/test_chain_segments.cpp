#include "pieces/chain_segments.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_chain_segments {

using namespace paper;

SurfacePoint in_face(double v, double w) { return make_surface_point(FaceId(0), {1 - v - w, v, w}); }

Segment segment(int left, int right, const SurfacePoint& begin, const SurfacePoint& end) {
  return {GeneratorId(left), GeneratorId(right), begin, end};
}

TEST_CASE("segments of the same two cells are joined, in whatever order they come") {
  const Mesh mesh = test::make_triangle();
  const SurfacePoint a = in_face(0.5, 0), b = in_face(0.4, 0.2), c = in_face(0.3, 0.3), d = in_face(0.5, 0.5);
  const Chains chains = chain_segments(mesh, {segment(0, 1, b, c), segment(0, 1, a, b), segment(0, 1, c, d)});
  REQUIRE(chains.bisectors.size() == 1);
  CHECK(chains.bisectors[0].points == std::vector<SurfacePoint>{a, b, c, d});
  CHECK_FALSE(chains.bisectors[0].closed);
  CHECK(chains.open_ends == 0);
}

TEST_CASE("a closed chain does not repeat its first point") {
  const Mesh mesh = test::make_triangle();
  const SurfacePoint a = in_face(0.2, 0.2), b = in_face(0.4, 0.2), c = in_face(0.3, 0.4);
  const Chains chains = chain_segments(mesh, {segment(0, 1, a, b), segment(0, 1, b, c), segment(0, 1, c, a)});
  REQUIRE(chains.bisectors.size() == 1);
  CHECK(chains.bisectors[0].closed);
  CHECK(chains.bisectors[0].points.size() == 3);
}

TEST_CASE("three chains end at a branch point, and one alone inside a face is open") {
  const Mesh mesh = test::make_triangle();
  const SurfacePoint middle = in_face(0.3, 0.3);
  const Chains branched =
      chain_segments(mesh, {segment(0, 1, in_face(0.5, 0), middle), segment(1, 2, in_face(0.5, 0.5), middle),
                            segment(2, 0, in_face(0, 0.5), middle)});
  CHECK(branched.bisectors.size() == 3);
  CHECK(branched.open_ends == 0);
  CHECK(chain_segments(mesh, {segment(0, 1, in_face(0.5, 0), middle)}).open_ends == 1);
}

TEST_CASE("a chain goes on in the next face, and its points share faces") {
  const Mesh mesh = test::make_grid(1, 1);
  const HalfedgeId h = Mesh::halfedge(FaceId(0), 2), twin = mesh.twin(h);
  REQUIRE(twin.valid());
  const SurfacePoint here = edge_point(h, 0.25), there = edge_point(twin, 0.75);
  const SurfacePoint begin = make_surface_point(FaceId(0), {0.2, 0.6, 0.2});
  const SurfacePoint end = make_surface_point(FaceId(1), {0.2, 0.3, 0.5});
  const Chains chains = chain_segments(mesh, {segment(0, 1, begin, here), segment(0, 1, there, end)});
  REQUIRE(chains.bisectors.size() == 1);
  CHECK(chains.bisectors[0].points.size() == 3);
  CHECK(chains.open_ends == 2);
}

}  // namespace gvd::test_chain_segments
