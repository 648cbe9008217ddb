// Curves from files, and on a mesh.

#include <cmath>

#include "gvd/curve_list.hpp"
#include "gvd/error.hpp"
#include "gvd/exact_field.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/refusal.hpp"

namespace gvd::test_curve_list {

using Segments = std::vector<std::array<std::int32_t, 2>>;

TEST_CASE("lines of OBJ and PLY with vertices in common are one curve") {
  const CurveList obj =
      parse_curves("v 0 0 0\nv 1 0 0\nv 5 5 5\nv 1 1 0\nv 3 0 0\nv 4 0 0\nl 1 2\nf 1 2 4\nl 4 2\nl 5 -1\n", "a.obj");
  CHECK(obj.curve == std::vector<std::int32_t>{0, 0, 0, 1, 1});
  CHECK(obj.segments == Segments{{0, 1}, {2, 1}, {3, 4}});
  CHECK(obj.points.entries[2].values == std::array<double, 3>{1, 1, 0});
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
  const CurveList ply = parse_curves(
      header +
          "element edge 2\nproperty int vertex1\nproperty int vertex2\nend_header\n0 0 0\n1 0 0\n2 0 0\n2 1\n1 0\n",
      "a.ply");
  CHECK(ply.curve == std::vector<std::int32_t>{0, 0, 0});
  CHECK(ply.segments == Segments{{2, 1}, {1, 0}});
}

TEST_CASE("text has a curve for each block of lines, and JSON for each object with points") {
  const CurveList text = parse_curves("0\n5  # a comment\n# between\n7\n\n\n9\n3 0.2 0.3 0.5\n", "c.txt");
  CHECK(text.curve == std::vector<std::int32_t>{0, 0, 0, 1, 1});
  CHECK(text.segments == Segments{{0, 1}, {1, 2}, {3, 4}});
  const CurveList json = parse_curves(
      R"({"paths":[],"isolines":[{"closed":true,"points":[{"vertex":1},{"vertex":2},{"vertex":3}]},{"points":[{"position":[1,2,3]}]}]})",
      "c.json");
  CHECK(json.curve == std::vector<std::int32_t>{0, 0, 0, 1});
  CHECK(json.segments == Segments{{0, 1}, {1, 2}, {2, 0}});
  const CurveList branched =
      parse_curves(R"({"curves":[{"points":[{"vertex":1},{"vertex":2},{"vertex":3}],"segments":[[0,1],[0,2]]}]})", "d");
  CHECK(branched.segments == Segments{{0, 1}, {0, 2}});
}

TEST_CASE("what is no curve is refused in one line with its place") {
  const auto refusal = [](const std::string& content, const std::string& name) {
    return test::refusal([&] { parse_curves(content, name); }, ErrorCode::unreadable_input);
  };
  using Catch::Matchers::Contains;
  CHECK_THAT(refusal("v 0 0 0\nv 1 0 0\n", "a.obj"), Contains("a.obj: the file holds no curve"));
  CHECK_THAT(refusal("v 0 0 0\nl 1 7\n", "a.obj"), Contains("a.obj:2: a line refers to vertex 7, and the file has 1"));
  CHECK_THAT(refusal("v 0 0 0\nl 1 x\n", "a.obj"), Contains("a.obj:2"));
  CHECK_THAT(refusal("", "c.txt"), Contains("no curve"));
  CHECK_THAT(refusal("1 2\n", "c.txt"), Contains("c.txt:1: 2 fields"));
  CHECK_THAT(refusal(R"({"curves":3})", "c.json"), Contains("\"curves\" must be an array"));
  CHECK_THAT(refusal(R"({"curves":[{"points":[4]}]})", "c.json"), Contains("is not an object"));
  CHECK_THAT(refusal(R"({"curves":[{"points":[{"vertex":4}],"segments":[[0,1]]}]})", "c.json"), Contains("pairs"));
  CHECK_THAT(refusal(R"({"curve":[]})", "c.json"), Contains("there is no array"));
  CHECK_THAT(refusal("{", "c.json"), Contains("not valid JSON"));
  CHECK_THAT(refusal("ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty float z\n"
                     "end_header\n",
                     "a.ply"),
             Contains("no element 'edge'"));
  CHECK_THAT(test::refusal([] { read_curves("/nowhere/c.txt"); }, ErrorCode::unreadable_input),
             Contains("no such file"));
}

TEST_CASE("points far apart are joined by the shortest path between them") {
  const Mesh mesh = test::make_torus(16, 9);
  CurveList list{{"a list", {}}, {}, {}};
  for (const int v : {0, 40, 95}) {
    list.points.entries.push_back({GeneratorEntry::Kind::vertex, v, {}, 1});
    list.curve.push_back(0);
  }
  list.segments = {{0, 1}, {1, 2}};
  ResolvedGenerators snapped;
  const std::vector<GeneratorCurve> curves = resolve_curves(mesh, list, {}, snapped);
  REQUIRE(curves.size() == 1);
  CHECK_NOTHROW(check_curves(mesh, curves));
  double length = 0;
  for (const auto& [a, b] : curves[0].segments) {
    length += (position(mesh, curves[0].points[a]) - position(mesh, curves[0].points[b])).norm();
  }
  const double first = ExactField(mesh, {vertex_point(mesh, VertexId(0))}).distance(VertexId(40));
  const double second = ExactField(mesh, {vertex_point(mesh, VertexId(95))}).distance(VertexId(40));
  CHECK(length == Approx(first + second).epsilon(1e-12));
  list.curve = {0, 1, 1};  // the second point is that of the first curve too
  list.points.entries[1] = list.points.entries[0];
  list.segments = {{1, 2}};
  CHECK(resolve_curves(mesh, list, {}, snapped).size() == 1);
  const Mesh two = test::make_two_components();
  list.segments = {{0, 1}};
  list.points.entries = {{GeneratorEntry::Kind::vertex, 0, {}, 1},
                         {GeneratorEntry::Kind::vertex, two.vertex_count() - 1, {}, 2}};
  list.curve = {0, 0};
  CHECK_THAT(test::refusal([&] { resolve_curves(two, list, {}, snapped); }, ErrorCode::precondition),
             Catch::Matchers::Contains("different components"));
}

}  // namespace gvd::test_curve_list
