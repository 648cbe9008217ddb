#include <cmath>
#include <random>

#include "base/barycentric.hpp"
#include "gvd/error.hpp"
#include "mesh/working_mesh.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_working_mesh {

/// Rebuilds the connectivity from scratch: the Mesh constructor refuses whatever is not a manifold.
void require_sound(const WorkingMesh& working) {
  const Mesh& mesh = working.mesh();
  std::vector<std::array<VertexId, 3>> faces;
  for (int f = 0; f < mesh.face_count(); ++f) faces.push_back(mesh.vertices(FaceId(f)));
  const Mesh rebuilt(mesh.positions(), faces);
  REQUIRE(rebuilt.edge_count() == mesh.edge_count());
  for (int i = 0; i < mesh.halfedge_count(); ++i) {
    const HalfedgeId h(i);
    REQUIRE(mesh.twin(h) == rebuilt.twin(h));
    REQUIRE(mesh.length(h) == Approx(rebuilt.length(h)));
  }
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    REQUIRE(mesh.from(mesh.halfedge(VertexId(v))) == VertexId(v));
    REQUIRE(mesh.is_boundary(VertexId(v)) == rebuilt.is_boundary(VertexId(v)));
  }
}

void require_same_surface(const WorkingMesh& working) {
  const Mesh &mesh = working.mesh(), &input = working.input();
  CHECK(compute_mesh_summary(mesh).area == Approx(compute_mesh_summary(input).area).epsilon(1e-12));
  for (int i = 0; i < mesh.face_count(); ++i) {
    const FaceId f(i);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      std::array<double, 3> bary{0, 0, 0};
      bary[corner] = 1;
      const Vec3 expected = position(input, {working.parent(f), working.parent_bary(f, bary)});
      REQUIRE((mesh.position(mesh.vertices(f)[corner]) - expected).norm() < 1e-12 * input.bbox_diagonal());
    }
  }
}

std::vector<SurfacePoint> random_points(const Mesh& mesh, int count, unsigned seed) {
  std::mt19937 random(seed);
  const auto real = [&] { return double(random()) / double(std::mt19937::max()); };
  std::vector<SurfacePoint> points;
  for (int i = 0; i < count; ++i) {
    const FaceId f(static_cast<int>(random() % static_cast<unsigned>(mesh.face_count())));
    const double u = real(), v = real() * (1 - u);
    switch (i % 4) {
      case 0:
        points.push_back(edge_point(Mesh::halfedge(f, i % 3), 0.01 + 0.98 * u));
        break;
      default:
        points.push_back(make_surface_point(f, {u, v, 1 - u - v}));
    }
  }
  return points;
}

TEST_CASE("every generator becomes a vertex, and the surface stays") {
  for (const auto& [name, mesh] : test::small_family()) {
    for (unsigned seed = 0; seed < 3; ++seed) {
      for (const int count : {1, 7, 60, 700}) {
        INFO(name << ", seed " << seed << ", " << count << " generators");
        const auto generators = random_points(mesh, count, seed);
        const WorkingMesh working(mesh, generators);
        require_sound(working);
        require_same_surface(working);
        for (int i = 0; i < count; ++i) {
          const VertexId v = working.vertex(GeneratorId(i));
          REQUIRE((working.mesh().position(v) - position(mesh, generators[i])).norm() < 1e-12 * mesh.bbox_diagonal());
          REQUIRE(working.generator(v) == GeneratorId(i));
        }
      }
    }
  }
}

TEST_CASE("a generator next to another one splits the face or the edge on whose side it lies") {
  // Seen from the second generator, all edges at the first one are near. It used to split one of them though it lay
  // far to the side, which turned a face over.
  const auto ids = [](int a, int b, int c) { return std::array<VertexId, 3>{VertexId(a), VertexId(b), VertexId(c)}; };
  const Mesh mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {ids(0, 1, 2)});
  for (const double apart : {1e-5, 1e-9, 1e-10, 1e-11}) {
    for (int direction = 0; direction < 24; ++direction) {
      INFO(apart << " apart, direction " << direction);
      const double angle = 0.26 * direction, dx = apart * std::cos(angle), dy = apart * std::sin(angle);
      const SurfacePoint first{FaceId(0), {0.5, 0.2, 0.3}}, second{FaceId(0), {0.5 - dx - dy, 0.2 + dx, 0.3 + dy}};
      const WorkingMesh working(mesh, {first, second});
      double area = 0;
      for (int f = 0; f < working.mesh().face_count(); ++f) {
        const auto corner = [&](const Bary& bary) { return affine_point(working.parent_bary(FaceId(f), bary)); };
        const double part = twice_signed_area(corner({1, 0, 0}), corner({0, 1, 0}), corner({0, 0, 1}));
        CHECK(part > 0);
        area += part;
      }
      CHECK(area == Approx(1).epsilon(1e-14));
    }
  }
}

TEST_CASE("generators on vertices copy nothing") {
  const Mesh mesh = test::make_sphere(1);
  const WorkingMesh working(mesh, {vertex_point(mesh, VertexId(3)), vertex_point(mesh, VertexId(9))});
  CHECK(&working.mesh() == &mesh);
  CHECK(working.vertex(GeneratorId(1)) == VertexId(9));
}

TEST_CASE("coincident generators are refused with both names, whichever faces they are given in") {
  const Mesh mesh = test::make_sphere(1);
  const HalfedgeId h = Mesh::halfedge(FaceId(0), 1), twin = mesh.twin(h);
  const auto refused = [&](const std::vector<SurfacePoint>& generators) {
    CHECK_THROWS_WITH(WorkingMesh(mesh, generators), Catch::Matchers::Contains("generators 0 and 1 coincide"));
  };
  refused({edge_point(h, 0.25), edge_point(twin, 0.75)});
  refused({make_surface_point(FaceId(2), {0.2, 0.3, 0.5}), make_surface_point(FaceId(2), {0.2, 0.3, 0.5})});
  refused(
      {make_surface_point(FaceId(2), {0.2, 0.3, 0.5}), make_surface_point(FaceId(2), {0.2, 0.3 + 1e-13, 0.5 - 1e-13})});
  refused({vertex_point(mesh, mesh.from(h)), edge_point(h, 0.0)});
}

TEST_CASE("a single triangle and a pillow of two faces accept generators on every edge") {
  const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const auto ids = [](int a, int b, int c) { return std::array<VertexId, 3>{VertexId(a), VertexId(b), VertexId(c)}; };
  const Mesh lone(corners, {ids(0, 1, 2)}), pillow(corners, {ids(0, 1, 2), ids(1, 0, 2)});
  for (const Mesh& mesh : {lone, pillow}) {
    std::vector<SurfacePoint> generators;
    for (int corner = 0; corner < 3; ++corner) {
      for (const double t : {0.75, 0.25, 0.5}) generators.push_back(edge_point(Mesh::halfedge(FaceId(0), corner), t));
    }
    generators.push_back(make_surface_point(FaceId(0), {0.3, 0.3, 0.4}));
    const WorkingMesh working(mesh, generators);
    require_same_surface(working);
    // The two sides of the pillow may hold different edges between the same vertices: no vertex list can rebuild it.
    if (mesh.face_count() == 1) require_sound(working);
    for (int i = 0; i < working.mesh().halfedge_count(); ++i) {
      const HalfedgeId h(i), twin = working.mesh().twin(h);
      if (twin.valid()) REQUIRE(working.mesh().from(twin) == working.mesh().to(h));
    }
  }
}

TEST_CASE("in a face without area, a generator on an edge where the opposite corner lies takes that corner") {
  // Corner 2 lies in the middle of the edge 0 1.
  const auto ids = [](int a, int b, int c) { return std::array<VertexId, 3>{VertexId(a), VertexId(b), VertexId(c)}; };
  const Mesh mesh({{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {ids(0, 1, 3), ids(1, 0, 2)});
  for (const FaceId f : {FaceId(0), FaceId(1)}) {
    CHECK(WorkingMesh(mesh, {edge_point(Mesh::halfedge(f, 0), 0.5)}).vertex(GeneratorId(0)) == VertexId(2));
  }
  // The face's other edges are split first, so that the corner is opposite no more.
  const WorkingMesh working(
      mesh, {edge_point(Mesh::halfedge(FaceId(1), 1), 0.5), edge_point(Mesh::halfedge(FaceId(1), 2), 0.5),
             edge_point(Mesh::halfedge(FaceId(0), 0), 0.5)});
  CHECK(working.vertex(GeneratorId(2)) == VertexId(2));
  CHECK_THROWS_WITH(WorkingMesh(mesh, {vertex_point(mesh, VertexId(2)), edge_point(Mesh::halfedge(FaceId(0), 0), 0.5)}),
                    Catch::Matchers::Contains("generators 0 and 1 coincide"));
}

TEST_CASE("far from the origin generators coincide if their positions differ by rounding only") {
  const auto ids = [](int a, int b, int c) { return std::array<VertexId, 3>{VertexId(a), VertexId(b), VertexId(c)}; };
  const Mesh mesh({{1e6, 0, 0}, {1e6 + 1, 0, 0}, {1e6, 1, 0}}, {ids(0, 1, 2)});
  const auto at = [](double t) { return make_surface_point(FaceId(0), {t, 0.5 - t, 0.5}); };
  CHECK_THROWS_WITH(WorkingMesh(mesh, {at(0.25), at(0.25 + 1e-11)}),
                    Catch::Matchers::Contains("generators 0 and 1 coincide"));
  CHECK_NOTHROW(WorkingMesh(mesh, {at(0.25), at(0.25 + 1e-8)}));
}

TEST_CASE("generators on two edges coincide where they are nearer to each other than to the common vertex") {
  const auto ids = [](int a, int b, int c) { return std::array<VertexId, 3>{VertexId(a), VertexId(b), VertexId(c)}; };
  const Mesh wedge({{0, 0, 0}, {1, 0, 0}, {1, 0.1, 0}}, {ids(0, 1, 2)});
  const auto at = [&](double t) {
    return std::vector{edge_point(Mesh::halfedge(FaceId(0), 0), t), edge_point(Mesh::halfedge(FaceId(0), 2), 1 - t)};
  };
  std::vector<SurfacePoint> near = at(5e-12);
  CHECK_THROWS_WITH(WorkingMesh(wedge, near), Catch::Matchers::Contains("generators 0 and 1 coincide"));
  std::swap(near[0], near[1]);
  CHECK_THROWS_WITH(WorkingMesh(wedge, near), Catch::Matchers::Contains("generators 0 and 1 coincide"));
  CHECK_NOTHROW(WorkingMesh(wedge, at(2e-11)));
}

TEST_CASE("generators at one position on the two faces of a pillow do not coincide") {
  const auto ids = [](int a, int b, int c) { return std::array<VertexId, 3>{VertexId(a), VertexId(b), VertexId(c)}; };
  const Mesh pillow({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {ids(0, 1, 2), ids(1, 0, 2)});
  for (const double rest : {1.0 / 3, 1e-3}) {
    const double most = 1 - 2 * rest;
    for (const auto& [front, back] : {std::pair(std::array{most, rest, rest}, std::array{rest, most, rest}),
                                      std::pair(std::array{rest, rest, most}, std::array{rest, rest, most})}) {
      const WorkingMesh working(pillow, {make_surface_point(FaceId(0), front), make_surface_point(FaceId(1), back)});
      CHECK(working.vertex(GeneratorId(0)) != working.vertex(GeneratorId(1)));
    }
  }
}

TEST_CASE("generators are sorted by what they lie on, and along each edge") {
  const Mesh mesh = test::make_grid(1, 1);
  HalfedgeId diagonal;
  for (int i = mesh.halfedge_count(); i-- > 0;) {
    if (mesh.twin(HalfedgeId(i)).valid()) diagonal = HalfedgeId(i);
  }
  const SortedPoints sorted =
      sort_points(mesh, {edge_point(diagonal, 0.75), vertex_point(mesh, VertexId(2)),
                         edge_point(mesh.twin(diagonal), 0.5), make_surface_point(FaceId(1), {0.2, 0.3, 0.5}),
                         make_surface_point(FaceId(1), {0.5, 0.3, 0.2}), edge_point(diagonal, 0.25)});
  REQUIRE(sorted.on_vertices.size() == 1);
  CHECK(sorted.on_vertices[0] == std::pair(VertexId(2), PointId(1)));
  REQUIRE(sorted.on_edges.size() == 3);
  const int order[] = {5, 2, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(sorted.on_edges[i].halfedge == diagonal);
    CHECK(sorted.on_edges[i].t == 0.25 * double(i + 1));
    CHECK(sorted.on_edges[i].point == PointId(order[i]));
  }
  REQUIRE(sorted.in_faces.size() == 1);
  CHECK(sorted.in_faces.at(FaceId(1)) == std::vector<PointId>{PointId(3), PointId(4)});
}

TEST_CASE("every generator of a family is sorted once, on the halfedge that comes first") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const std::vector<SurfacePoint> generators = test::random_generators(mesh, 90, 3);
    const SortedPoints sorted = sort_points(mesh, generators);
    std::size_t count = sorted.on_vertices.size() + sorted.on_edges.size();
    for (const auto& [face, ids] : sorted.in_faces) count += ids.size();
    REQUIRE(count == generators.size());
    for (const PointOnEdge& on : sorted.on_edges) {
      REQUIRE((!mesh.twin(on.halfedge).valid() || on.halfedge < mesh.twin(on.halfedge)));
      const Vec3 expected = position(mesh, generators[on.point.index()]);
      REQUIRE((position(mesh, edge_point(on.halfedge, on.t)) - expected).norm() < 1e-14 * mesh.bbox_diagonal());
    }
  }
}

TEST_CASE("no generator, and one in a face that does not exist, are refused") {
  const Mesh mesh = test::make_triangle();
  CHECK_THROWS_AS(sort_points(mesh, {}), Error);
  CHECK_THROWS_AS(sort_points(mesh, {{FaceId(1), {1, 0, 0}}}), Error);
  CHECK_THROWS_AS(sort_points(mesh, {{FaceId(), {1, 0, 0}}}), Error);
}

}  // namespace gvd::test_working_mesh
