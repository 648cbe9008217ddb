// Curves as chains of edges of a working mesh.

#include <algorithm>
#include <cmath>
#include <random>

#include "gvd/error.hpp"
#include "gvd/generator_curve.hpp"
#include "mesh/working_mesh.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/refusal.hpp"

namespace gvd::test_insert_curves {

SurfacePoint at(int face, double b0, double b1, double b2) { return make_surface_point(FaceId(face), {b0, b1, b2}); }

double area_of(const Mesh& mesh) {
  double area = 0;
  for (const FaceId f : mesh.faces()) area += mesh.area(f);
  return area;
}

double length_of(const WorkingMesh& working) {
  double length = 0;
  for (const HalfedgeId h : working.curves().edges) length += working.mesh().length(h);
  return length;
}

TEST_CASE("a polyline inside one face becomes edges of the working mesh, and the surface stays the same") {
  const Mesh mesh = test::make_grid(1, 1);
  std::mt19937 random(5);
  const auto real = [&] { return double(random()) / double(std::mt19937::max()); };
  for (int run = 0; run < 200; ++run) {
    CAPTURE(run);
    std::vector<SurfacePoint> points;
    for (int i = 0; i < 3 + run % 9; ++i) {
      const double u = real(), v = (1 - u) * real();
      points.push_back(make_surface_point(FaceId(0), {u, v, 1 - u - v}));
    }
    const GeneratorCurve curve = make_polyline(points, run % 2 == 0);
    const WorkingMesh working(mesh, std::vector{curve});
    double length = 0;
    for (const auto& [a, b] : curve.segments) {
      length += (position(mesh, points[a]) - position(mesh, points[b])).norm();
    }
    CHECK(length_of(working) == Approx(length).epsilon(1e-10));
    CHECK(area_of(working.mesh()) == Approx(area_of(mesh)).epsilon(1e-12));
    for (const auto& [v, g] : working.curves().vertices) {
      CHECK(g == GeneratorId(0));
      CHECK(working.generator(v) == g);
    }
  }
}

TEST_CASE("curves along edges and through vertices need no other vertex than their own") {
  const Mesh mesh = test::make_grid(3, 1);
  // Along the lower side: through two vertices, and from the middle of one edge to that of another.
  std::vector<SurfacePoint> points;
  for (const VertexId v : mesh.vertices()) {
    if (mesh.position(v).y() == 0) points.push_back(vertex_point(mesh, v));
  }
  std::ranges::sort(points, {}, [&](const SurfacePoint& p) { return position(mesh, p).x(); });
  const WorkingMesh same(mesh, std::vector{make_polyline(points, false)});
  CHECK(&same.mesh() == &mesh);
  CHECK(same.curves().edges.size() == 3);
}

TEST_CASE("a point alone is a generator as usual, beside curves too") {
  const Mesh mesh = test::make_sphere(1);
  const GeneratorCurve point{{at(3, 0.2, 0.3, 0.5)}};
  const GeneratorCurve line = make_polyline({at(40, 0.2, 0.3, 0.5), at(40, 0.6, 0.3, 0.1)}, false);
  const WorkingMesh working(mesh, std::vector{point, line});
  CHECK(working.curves().vertices.size() == 2);
  CHECK(working.generator(working.vertex(GeneratorId(0))) == GeneratorId(0));
  const WorkingMesh points(mesh, std::vector<SurfacePoint>{at(3, 0.2, 0.3, 0.5)});
  CHECK(points.curves().empty());
}

TEST_CASE("curves that can't be generators are refused by their numbers") {
  const Mesh mesh = test::make_grid(2, 1);
  const auto refusal = [&](const std::vector<GeneratorCurve>& curves) {
    return test::refusal([&] { WorkingMesh(mesh, curves); }, ErrorCode::precondition);
  };
  using Catch::Matchers::Contains;
  CHECK_THAT(refusal({}), Contains("there is no curve"));
  CHECK_THAT(refusal({GeneratorCurve{}}), Contains("curve 0 has no point"));
  CHECK_THAT(refusal({GeneratorCurve{{at(9, 1, 0, 0)}}}), Contains("face 9, and the mesh has 4"));
  CHECK_THAT(refusal({GeneratorCurve{{at(0, 0.2, 0.3, 0.5)}, {{0, 1}}}}), Contains("and 1 points"));
  CHECK_THAT(refusal({GeneratorCurve{{at(0, 0.2, 0.3, 0.5), at(0, 0.3, 0.2, 0.5)}}}), Contains("2 separate parts"));
  CHECK_THAT(refusal({make_polyline({at(0, 0.2, 0.3, 0.5), at(3, 0.3, 0.2, 0.5)}, false)}),
             Contains("curve 0 jumps from point 0 to point 1"));
  const GeneratorCurve across = make_polyline({at(0, 0.8, 0.1, 0.1), at(0, 0.1, 0.1, 0.8)}, false);
  const GeneratorCurve along = make_polyline({at(0, 0.1, 0.1, 0.8), at(0, 0.1, 0.8, 0.1)}, false);
  const GeneratorCurve crossing = make_polyline({at(0, 0.1, 0.8, 0.1), at(0, 0.45, 0.05, 0.5)}, false);
  CHECK_THAT(refusal({across, crossing}), Contains("curves 0 and 1 cross in face 0"));
  CHECK_THAT(refusal({across, along}), Contains("curves 0 and 1 meet at (0.9, 0.8, 0); give both a point there"));
  // The end of one on the inside of the other.
  const GeneratorCurve touching = make_polyline({at(0, 0.45, 0.1, 0.45), at(0, 0.1, 0.8, 0.1)}, false);
  CHECK_THAT(refusal({across, touching}), Contains("curves 0 and 1 meet at (0.55, 0.45, 0)"));
  CHECK_NOTHROW(WorkingMesh(mesh, std::vector{across, GeneratorCurve{{at(3, 0.2, 0.3, 0.5)}}}));
}

}  // namespace gvd::test_insert_curves
