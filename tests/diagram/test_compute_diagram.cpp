// The whole pipeline on degenerate input; scale, repetition and progress are in test_compute_diagram_runs.cpp.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/error.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/sound_diagram.hpp"
#include "support/stages.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_compute_diagram {

using test::compute_sound;
using test::kFronts;

double area_sum(const Diagram& diagram) {
  double sum = 0;
  for (const Cell& cell : diagram.cells) sum += cell.area;
  return sum;
}

/// The error message for these generators.
Error refusal(const Mesh& mesh, const std::vector<SurfacePoint>& generators) {
  try {
    compute_diagram(mesh, generators);
  } catch (const Error& error) {
    return error;
  }
  FAIL("was not refused");
  throw;
}

TEST_CASE("a single triangle: one, two and three generators, at corners, on edges and inside") {
  const Mesh mesh = test::make_triangle();
  for (const Front front : kFronts) {
    const Diagram one = compute_sound(mesh, test::at_vertices(mesh, {1}), front);
    CHECK(one.bisectors.empty());
    CHECK(one.face_label[FaceId(0)] == GeneratorId(0));
    const Diagram two = compute_sound(mesh, test::at_vertices(mesh, {0, 2}), front);
    REQUIRE(two.bisectors.size() == 1);
    CHECK_FALSE(two.bisectors[BisectorId(0)].closed);
    const Diagram three = compute_sound(mesh, test::at_vertices(mesh, {0, 1, 2}), front);
    CHECK(three.branch_points.size() == 1);
    CHECK(three.bisectors.size() == 3);
    CHECK(area_sum(three) == Approx(mesh.area(FaceId(0))));
  }
  const SurfacePoint inside = make_surface_point(FaceId(0), {0.3, 0.4, 0.3}),
                     beside = make_surface_point(FaceId(0), {0.6, 0.1, 0.3});
  const SurfacePoint on_edge = edge_point(Mesh::halfedge(FaceId(0), 1), 0.5);
  compute_sound(mesh, {inside});
  compute_sound(mesh, {on_edge});
  compute_sound(mesh, {inside, on_edge});
  compute_sound(mesh, {inside, beside, on_edge});
  compute_sound(mesh, {inside, beside, on_edge, vertex_point(mesh, VertexId(0)), vertex_point(mesh, VertexId(1))});
}

TEST_CASE("three corners of a triangle: the branch point is the circumcentre") {
  const Mesh mesh = test::make_triangle();
  const Diagram diagram = compute_sound(mesh, test::at_vertices(mesh, {0, 1, 2}));
  const Vec3 centre = diagram.branch_points[BranchPointId(0)].position;
  for (int v = 0; v < 3; ++v) {
    CHECK((centre - mesh.position(VertexId(v))).norm() ==
          Approx(diagram.branch_points[BranchPointId(0)].distance).epsilon(1e-6));
  }
}

TEST_CASE("a pillow of two triangles: closed, with up to eight generators") {
  const Mesh mesh = test::make_pillow();
  for (const Front front : kFronts) {
    CHECK(compute_sound(mesh, test::at_vertices(mesh, {0}), front).cells[GeneratorId(0)].euler_characteristic == 2);
    const Diagram two = compute_sound(mesh, test::at_vertices(mesh, {0, 1}), front);
    REQUIRE(two.bisectors.size() == 1);
    CHECK(two.bisectors[BisectorId(0)].closed);
    const Diagram three = compute_sound(mesh, test::at_vertices(mesh, {0, 1, 2}), front);
    CHECK(three.branch_points.size() == 2);
    for (unsigned seed = 0; seed < 50; ++seed) {
      for (int count = 1; count <= 8; ++count) compute_sound(mesh, test::random_generators(mesh, count, seed), front);
    }
  }
}

TEST_CASE("one generator owns its whole component, on every family, from a vertex, an edge and a face") {
  for (const auto& [name, mesh] : test::small_family()) {
    const auto component = compute_face_components(mesh);
    const SurfacePoint inside = make_surface_point(FaceId(0), {0.2, 0.3, 0.5});
    for (const SurfacePoint& g : {vertex_point(mesh, VertexId(0)), edge_point(mesh.halfedge(EdgeId(0)), 0.4), inside}) {
      for (const Front front : kFronts) {
        INFO(name << ", " << test::name(front));
        const Diagram diagram = compute_sound(mesh, {g}, front);
        REQUIRE(diagram.bisectors.empty());
        REQUIRE(diagram.branch_points.empty());
        double owned = 0;
        for (int f = 0; f < mesh.face_count(); ++f) {
          if (component[FaceId(f)] == component[g.face]) owned += mesh.area(FaceId(f));
        }
        REQUIRE(diagram.cells[GeneratorId(0)].area == Approx(owned));
        REQUIRE(diagram.cells[GeneratorId(0)].components == 1);
        REQUIRE(diagram.length == 0);
      }
    }
  }
}

TEST_CASE("two generators on closed surfaces: all bisectors are closed, and there is no branch point") {
  for (const Mesh& mesh :
       {test::make_sphere(2), test::make_torus(24, 12), test::make_plate(10), test::make_genus3(3)}) {
    for (const Front front : kFronts) {
      for (unsigned seed = 0; seed < 10; ++seed) {
        const Diagram diagram = compute_sound(mesh, test::random_generators(mesh, 2, seed), front);
        REQUIRE(diagram.branch_points.empty());
        REQUIRE(diagram.bisectors.size() >= 1);
        for (const Bisector& b : diagram.bisectors) REQUIRE(b.closed);
        for (const Cell& cell : diagram.cells) REQUIRE(cell.neighbours.size() == 1);
      }
    }
  }
}

TEST_CASE("a closed bisector around a tube: both cells are annuli") {
  const Mesh ring = test::make_ring(12, 8);  // after this 16 high, with a circumference of 6.2
  std::vector<Vec3> positions = ring.positions();
  for (Vec3& p : positions) p.z() *= 32;
  std::vector<std::array<VertexId, 3>> faces;
  for (int f = 0; f < ring.face_count(); ++f) faces.push_back(ring.vertices(FaceId(f)));
  const Mesh tube(positions, faces);
  for (const Front front : kFronts) {
    const Diagram diagram =
        compute_sound(tube, test::at_vertices(tube, {0, 8}), front);  // at the bottom and at the top
    REQUIRE(diagram.bisectors.size() == 1);
    CHECK(diagram.bisectors[BisectorId(0)].closed);
    for (const Cell& cell : diagram.cells) {
      CHECK(cell.euler_characteristic == 0);
      CHECK(cell.boundary_loops == 2);
    }
    CHECK(diagram.length == Approx(24 * std::sin(std::numbers::pi / 12)).epsilon(0.1));
  }
}

TEST_CASE("a tetrahedron: its four corners, and many generators") {
  const Mesh mesh = test::make_tetrahedron();
  for (const Front front : kFronts) {
    const Diagram four = compute_sound(mesh, test::at_vertices(mesh, {0, 1, 2, 3}), front);
    CHECK(four.branch_points.size() == 4);
    for (const Cell& cell : four.cells) {
      CHECK(cell.neighbours.size() == 3);
      CHECK(cell.area == Approx(area_sum(four) / 4).epsilon(1e-6));
    }
    for (unsigned seed = 0; seed < 50; ++seed) compute_sound(mesh, test::random_generators(mesh, 12, seed), front);
  }
}

TEST_CASE("all generators on one edge: parallel bisectors across the faces beside it") {
  for (const Mesh& mesh : {test::make_grid(4, 4), test::make_sphere(1), test::make_triangle()}) {
    for (const Front front : kFronts) {
      for (const int count : {5, 80}) {
        CAPTURE(count);
        const auto generators = test::along_edge(Mesh::halfedge(FaceId(0), 1), count);
        const Diagram diagram = compute_sound(mesh, generators, front);
        for (std::size_t i = 0; i + 1 < generators.size(); ++i) {
          const auto& neighbours = diagram.cells[GeneratorId(i)].neighbours;
          CHECK(std::count(neighbours.begin(), neighbours.end(), GeneratorId(static_cast<std::int64_t>(i) + 1)) == 1);
        }
      }
    }
  }
}

TEST_CASE("generators on the boundary's edges and vertices") {
  for (const Mesh& mesh : {test::make_grid(6, 4), test::make_ring(12, 3), test::make_half_sphere(1)}) {
    std::vector<SurfacePoint> edges, vertices;
    for (int e = 0; e < mesh.edge_count(); ++e) {
      if (mesh.is_boundary(EdgeId(e))) edges.push_back(edge_point(mesh.halfedge(EdgeId(e)), e % 3 == 0 ? 0.5 : 0.3));
    }
    for (int v = 0; v < mesh.vertex_count(); ++v) {
      if (mesh.is_boundary(VertexId(v))) vertices.push_back(vertex_point(mesh, VertexId(v)));
    }
    for (const Front front : kFronts) {
      compute_sound(mesh, edges, front);
      compute_sound(mesh, vertices, front);
      std::vector<SurfacePoint> both = edges;
      both.insert(both.end(), vertices.begin(), vertices.end());
      compute_sound(mesh, both, front);
    }
  }
}

TEST_CASE("mirror-symmetric generators: whole bisectors lie on edges and through vertices") {
  const Mesh grid = test::make_grid(8, 8);
  const auto at = [](int i, int j) { return j * 9 + i; };
  for (const Front front : kFronts) {
    // The bisector runs along the column of edges i = 4.
    const Diagram two = compute_sound(grid, test::at_vertices(grid, {at(2, 4), at(6, 4)}), front);
    CHECK(two.bisectors.size() == 1);
    // Planar fronts interpolate distances: their bisector deviates from the column by up to a tenth of an edge.
    CHECK(two.length == Approx(8).epsilon(front == Front::circle ? 1e-6 : 0.01));
    // Along the diagonal, on which half of the edges lie.
    const Diagram diagonal = compute_sound(grid, test::at_vertices(grid, {at(2, 5), at(5, 2)}), front);
    CHECK(diagonal.bisectors.size() == 1);
    // Four cells with a common vertex.
    const Diagram four = compute_sound(grid, test::at_vertices(grid, {at(2, 2), at(6, 2), at(2, 6), at(6, 6)}), front);
    // Distances of a generator are less accurate beyond its cell: 0.4 % with circles.
    for (const Cell& cell : four.cells) CHECK(cell.area == Approx(16).epsilon(front == Front::circle ? 0.01 : 0.2));
    std::vector<int> all;
    for (int v = 0; v < grid.vertex_count(); ++v) all.push_back(v);
    const Diagram every = compute_sound(grid, test::at_vertices(grid, all), front);
    CHECK(every.cells.size() == 81);
  }
  for (const Mesh& mesh :
       {test::make_sphere(2), test::make_torus(24, 12), test::make_plate(10), test::make_genus3(3)}) {
    std::vector<SurfacePoint> mirrored;
    for (int v = 0; v < mesh.vertex_count(); v += 17) {
      const Vec3 p = mesh.position(VertexId(v));
      for (int u = 0; u < mesh.vertex_count(); ++u) {
        if (u != v && (mesh.position(VertexId(u)) - Vec3(p.x(), p.y(), -p.z())).norm() < 1e-12 && u > v) {
          mirrored.push_back(vertex_point(mesh, VertexId(v)));
          mirrored.push_back(vertex_point(mesh, VertexId(u)));
          break;
        }
      }
    }
    if (mirrored.size() < 2) continue;
    std::vector<SurfacePoint> distinct;
    for (const SurfacePoint& p : mirrored) {
      if (std::find(distinct.begin(), distinct.end(), p) == distinct.end()) distinct.push_back(p);
    }
    for (const Front front : kFronts) compute_sound(mesh, distinct, front);
  }
}

TEST_CASE("every vertex, every edge and every face a generator: more generators than faces") {
  for (const Mesh& mesh :
       {test::make_tetrahedron(), test::make_sphere(1), test::make_grid(3, 3), test::make_pillow()}) {
    std::vector<SurfacePoint> generators;
    for (int v = 0; v < mesh.vertex_count(); ++v) generators.push_back(vertex_point(mesh, VertexId(v)));
    for (int e = 0; e < mesh.edge_count(); ++e) generators.push_back(edge_point(mesh.halfedge(EdgeId(e)), 0.5));
    for (int f = 0; f < mesh.face_count(); ++f)
      generators.push_back(make_surface_point(FaceId(f), {1. / 3, 1. / 3, 1. / 3}));
    for (const Front front : kFronts) {
      const Diagram diagram = compute_sound(mesh, generators, front);
      CHECK(diagram.cells.size() > static_cast<std::size_t>(mesh.face_count()));
      for (const Cell& cell : diagram.cells) CHECK(cell.area > 0);
    }
  }
  const Mesh tetrahedron = test::make_tetrahedron();
  for (const Front front : kFronts) compute_sound(tetrahedron, test::random_generators(tetrahedron, 200, 3), front);
}

TEST_CASE("two components and one generator: the other one has no label and infinite distance") {
  const Mesh mesh = test::make_two_components();
  const auto component = compute_face_components(mesh);
  for (const Front front : kFronts) {
    for (const int v : {0, mesh.vertex_count() - 1}) {
      const Diagram diagram = compute_sound(mesh, test::at_vertices(mesh, {v}), front);
      const std::int32_t own = component[Mesh::face(mesh.halfedge(VertexId(v)))];
      for (int i = 0; i < mesh.vertex_count(); ++i) {
        const bool reached = component[Mesh::face(mesh.halfedge(VertexId(i)))] == own;
        REQUIRE(diagram.vertex_label[VertexId(i)].valid() == reached);
        REQUIRE(std::isfinite(diagram.vertex_distance[VertexId(i)]) == reached);
      }
      for (int f = 0; f < mesh.face_count(); ++f)
        REQUIRE(diagram.face_label[FaceId(f)].valid() == (component[FaceId(f)] == own));
      CHECK(diagram.pieces.empty());
      CHECK(diagram.bisectors.empty());
    }
  }
}

TEST_CASE("a generator's vertex has its label and distance zero, and no distance is negative") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const auto generators = test::random_generators(mesh, 50, 18);
    const Diagram diagram = compute_sound(mesh, generators);
    for (std::size_t i = 0; i < generators.size(); ++i) {
      if (generators[i].kind() != SurfacePoint::Kind::vertex) continue;
      REQUIRE(diagram.vertex_label[vertex(mesh, generators[i])] == GeneratorId(i));
      REQUIRE(diagram.vertex_distance[vertex(mesh, generators[i])] == 0);
    }
    for (const double d : diagram.vertex_distance) REQUIRE(d >= 0);
  }
}

TEST_CASE("a needle, a cap and nearly coincident generators") {
  const Mesh needle = test::make_mesh({{0, 0, 0}, {1, 0, 0}, {0.5, 1e-7, 0}, {0.5, -1, 0}}, {{0, 1, 2}, {1, 0, 3}});
  for (const Front front : kFronts) {
    compute_sound(needle, test::at_vertices(needle, {0, 1, 2}), front);
    compute_sound(needle, test::at_vertices(needle, {2, 3}), front);
    compute_sound(needle, test::random_generators(needle, 10, 2), front);
    const Mesh grid = test::make_grid(3, 3);
    for (const double apart : {1e-3, 1e-6, 1e-9}) {
      compute_sound(grid,
                    {make_surface_point(FaceId(4), {0.3, 0.3, 0.4}),
                     make_surface_point(FaceId(4), {0.3 + apart, 0.3, 0.4 - apart})},
                    front);
      compute_sound(grid, {vertex_point(grid, VertexId(5)), edge_point(grid.halfedge(VertexId(5)), apart)}, front);
    }
  }
}

TEST_CASE("no generator, a face that does not exist and coincident generators are refused") {
  const Mesh mesh = test::make_sphere(1);
  const auto at = [&](int v) { return vertex_point(mesh, VertexId(v)); };
  CHECK(refusal(mesh, {}).code() == ErrorCode::precondition);
  const Error nowhere = refusal(mesh, {at(0), SurfacePoint{FaceId(mesh.face_count()), {1, 0, 0}}});
  CHECK(nowhere.code() == ErrorCode::precondition);
  CHECK(nowhere.element() == 1);
  CHECK(refusal(mesh, {SurfacePoint{FaceId(), {1, 0, 0}}}).code() == ErrorCode::precondition);
  const SurfacePoint inside = make_surface_point(FaceId(3), {0.2, 0.3, 0.5});
  const HalfedgeId h = mesh.halfedge(EdgeId(7));
  // Inside a face, at a vertex as two faces see it, and on an edge from both of its sides.
  for (const auto& [p, q] : {std::pair(inside, inside), std::pair(vertex_point(mesh, mesh.from(h)), edge_point(h, 0.0)),
                             std::pair(edge_point(h, 0.25), edge_point(mesh.twin(h), 0.75))}) {
    const Error error = refusal(mesh, {at(20), p, at(30), q});
    CHECK(error.code() == ErrorCode::precondition);
    CHECK(error.element() == 3);
    CHECK_THAT(error.what(), Catch::Contains("1 and 3 coincide"));
  }
}

}  // namespace gvd::test_compute_diagram
