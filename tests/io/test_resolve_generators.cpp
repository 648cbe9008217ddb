// Entries of a list as points of a mesh.
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
  CHECK(message("1\n0\n") ==
        "list:2: vertex 0 is in no face of the mesh, or in a component that was dropped; choose another");
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

}  // namespace gvd::test_resolve_generators
