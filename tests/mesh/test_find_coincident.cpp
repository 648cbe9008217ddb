#include "gvd/diagram.hpp"
#include "mesh/find_coincident.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_find_coincident {

using test::make_grid;

TEST_CASE("points close across an edge coincide, points of two touching sheets do not") {
  const Mesh grid = make_grid(3, 3);
  const double tiny = 1e-13;
  // Face 0 is (0,0) (1,0) (1,1), face 1 is (0,0) (1,1) (0,1): they share the diagonal.
  const SurfacePoint below{FaceId(0), {0.5, tiny, 0.5 - tiny}}, above{FaceId(1), {0.5, 0.5 - tiny, tiny}};
  CHECK(find_coincident(grid, {below, above}) == std::vector<std::int32_t>{0, 0});
  const Mesh sheets({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                    {{VertexId(0), VertexId(1), VertexId(2)}, {VertexId(3), VertexId(5), VertexId(4)}});
  const SurfacePoint front = make_surface_point(FaceId(0), {0.2, 0.3, 0.5});
  const SurfacePoint back = make_surface_point(FaceId(1), {0.2, 0.5, 0.3});
  CHECK(find_coincident(sheets, {front, back}) == std::vector<std::int32_t>{0, 1});
}

TEST_CASE("far from the origin points coincide that rounding can't tell apart, and what does not coincide is taken") {
  const Mesh far({{1e6, 0, 0}, {1e6 + 1, 0, 0}, {1e6, 1, 0}}, {{VertexId(0), VertexId(1), VertexId(2)}});
  const auto at = [](double shift) { return make_surface_point(FaceId(0), {0.5 - shift, 0.3 + shift, 0.2}); };
  CHECK(find_coincident(far, {at(0), at(7e-10)}) == std::vector<std::int32_t>{0, 0});
  CHECK(find_coincident(far, {at(0), at(5e-9)}) == std::vector<std::int32_t>{0, 1});
  CHECK_NOTHROW(compute_diagram(far, {at(0), at(5e-9)}));
}

TEST_CASE("points on the two banks of a slit do not coincide, points round its tip do") {
  // A slit from (1, 0) to the tip at the origin: vertices 1 and 2 lie there together, on either bank.
  const std::vector<Vec3> positions{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  const auto face = [](int a, int b, int c) { return std::array{VertexId(a), VertexId(b), VertexId(c)}; };
  const Mesh slit(positions, {face(0, 1, 3), face(0, 3, 4), face(0, 4, 5), face(0, 5, 2)});
  const auto at = [](int f, double u, double v, double w) { return make_surface_point(FaceId(f), {u, v, w}); };
  CHECK(find_coincident(slit, {at(0, 0, 1, 0), at(3, 0, 0, 1)}) == std::vector<std::int32_t>{0, 1});
  CHECK(find_coincident(slit, {at(0, 0.5, 0.5, 0), at(3, 0.5, 0, 0.5)}) == std::vector<std::int32_t>{0, 1});
  CHECK(find_coincident(slit, {at(0, 0.4, 0.3, 0.3), at(0, 0.4, 0.3, 0.3)}) == std::vector<std::int32_t>{0, 0});
  const double tiny = 1e-14;
  CHECK(find_coincident(slit, {at(0, 1 - tiny, tiny, 0), at(3, 1 - tiny, 0, tiny)}) == std::vector<std::int32_t>{0, 0});
  CHECK(find_coincident(slit, {at(0, 0.5, tiny, 0.5 - tiny), at(1, 0.5, 0.5 - tiny, tiny)}) ==
        std::vector<std::int32_t>{0, 0});
}

}  // namespace gvd::test_find_coincident
