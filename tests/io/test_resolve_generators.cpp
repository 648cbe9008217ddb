// Entries of a list as points of a mesh, and points in the same place.
#include <cmath>
#include <limits>

#include "gvd/diagram.hpp"
#include "io/generator_fixture.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_resolve_generators {

using namespace test;

using Kind = GeneratorEntry::Kind;

TEST_CASE("vertices are those of the input file") {
  const Mesh mesh = make_grid(2, 2);
  const std::vector<VertexId> map{VertexId(), VertexId(4), VertexId(0)};
  ResolveOptions options;
  options.input_vertices = &map;
  const auto points = resolve_generators(mesh, parse("2\n1\n"), options).points;
  CHECK(vertex(mesh, points[0]) == VertexId(0));
  CHECK(vertex(mesh, points[1]) == VertexId(4));
  const auto message = [&](const std::string& text) {
    return refusal([&] { resolve_generators(mesh, parse(text), options); }, ErrorCode::precondition);
  };
  CHECK(message("1\n0\n") == "list:2: vertex 0 is in no face of the mesh; choose another");
  CHECK(message("3\n") == "list:1: there is no vertex 3; the mesh has 3, numbered from 0");
  CHECK(message("8 1 0 0\n") == "list:1: there is no face 8; the mesh has 8, numbered from 0");
  for (const auto kind : {Kind::vertex, Kind::face}) {
    GeneratorList list{"list", {}};
    list.entries.push_back({kind, std::numeric_limits<std::int64_t>::min() + 1, {1, 0, 0}, 0});
    CHECK_THAT(refusal([&] { resolve_generators(mesh, list, options); }, ErrorCode::precondition),
               Catch::Matchers::StartsWith("list: there is no "));
  }
  CHECK_THAT(message("1\n3 0.5 0.5 0.5\n"), Catch::Matchers::StartsWith("list:2: barycentric coordinates"));
  CHECK_THAT(message("3 1.5 -0.5 0\n"), Catch::Matchers::StartsWith("list:1: barycentric coordinates"));
  CHECK_THAT(message("3 1e300 0 0\n"), Catch::Matchers::Contains("1e+300 0 0 must"));
}

TEST_CASE("positions are snapped, and the largest distance is kept") {
  const Mesh mesh = make_grid(4, 4);
  ResolveOptions options;
  const ResolvedGenerators result =
      resolve_generators(mesh, parse("p 1.25 1.5 0.5\np -1 -1 0\n0 0.2 0.3 0.5\n"), options);
  CHECK(result.snap_distance[0] == 0.5);
  CHECK(*result.snap_distance[1] == Approx(std::sqrt(2.0)));
  CHECK(!result.snap_distance[2]);
  CHECK(result.farthest == "list:2");
  CHECK(result.longest_snap == result.snap_distance[1]);
  ResolveOptions merging;
  merging.merge_coincident = true;
  const auto merged = resolve_generators(mesh, parse("p 0 0 0\np -9 0 0\np 4 7 0\n"), merging);
  CHECK(merged.points.size() == 2);
  CHECK(merged.longest_snap == 9);
  CHECK(merged.farthest == "list:2");
  CHECK(resolve_generators(mesh, parse("0 0.2 0.3 0.5\n"), options).farthest.empty());
  CHECK((position(mesh, result.points[0]) - Vec3(1.25, 1.5, 0)).norm() < 1e-12);
  CHECK(result.points[1].kind() == SurfacePoint::Kind::vertex);
  options.max_snap = 0.5;
  CHECK(resolve_generators(mesh, parse("p 1.25 1.5 0.5\n"), options).snap_distance[0] == 0.5);
  CHECK_THAT(
      refusal([&] { resolve_generators(mesh, parse("p 1 1.5 0\np 1 1 1\n"), options); }, ErrorCode::precondition),
      Catch::Matchers::StartsWith("list:2: this position is 1 from the surface, more than the 0.5"));
  refusal([&] { resolve_generators(mesh, parse("p 1e300 1e300 0\n"), {}); }, ErrorCode::precondition);
}

// JSON reads -0 as 0.
TEST_CASE("a coordinate of -0 is 0 in each format of a list") {
  const Mesh mesh = make_grid(2, 2);
  for (const auto& [text, format] :
       {std::pair("3 1 -0 0\n", GeneratorFormat::text), {"3,1,-0,0\n", GeneratorFormat::csv}}) {
    const auto points = resolve_generators(mesh, parse(text, format)).points;
    for (const double b : points.at(0).bary) CHECK(!std::signbit(b));
  }
}

TEST_CASE("generators in one place are refused, or merged") {
  const Mesh mesh = make_sphere(2);
  // Vertex 0 three ways: by number, as a corner of a face, and by position.
  const SurfacePoint corner = vertex_point(mesh, VertexId(0));
  const Vec3 p = position(mesh, corner);
  SurfacePoint other = corner;
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (int i = 0; i < 3; ++i) {
      if (mesh.vertices(FaceId(f))[std::size_t(i)] == VertexId(0)) other = edge_point(Mesh::halfedge(FaceId(f), i), 0);
    }
  }
  REQUIRE(other.face != corner.face);
  const std::string text = "5\n0\n" + format_generators(mesh, {other}, GeneratorFormat::text);
  CHECK_THAT(refusal([&] { resolve_generators(mesh, parse(text)); }, ErrorCode::precondition),
             Catch::Matchers::StartsWith("list:4: point 2 is in the same place as vertex 0 (list:2); remove one"));
  ResolveOptions merge;
  merge.merge_coincident = true;
  const ResolvedGenerators merged = resolve_generators(mesh, parse(text + "7\n"), merge);
  CHECK(merged.points.size() == 3);
  CHECK(merged.merged == 1);
  CHECK(merged.snap_distance.size() == 3);
  GeneratorList list = parse("0\n");
  list.entries.push_back({Kind::position, 0, {p.x(), p.y(), p.z()}, 0});
  CHECK_THROWS_AS(resolve_generators(mesh, list), Error);
}

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

}  // namespace gvd::test_resolve_generators
