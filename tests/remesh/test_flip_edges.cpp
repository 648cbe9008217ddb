// Flips of a remesh's edges: better triangles and distances, the same topology, and curves that stay.
#include <algorithm>
#include <cmath>

#include "crease_meshes.hpp"
#include "dual/flipped_triangles.hpp"
#include "dual/self_intersections.hpp"
#include "flip_edges.hpp"
#include "gvd/quality.hpp"
#include "gvd/remesh.hpp"
#include "move_guard.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_flip_edges {

using Face = EdgeFlip::Face;

/// Four vertices in the plane; the edge from the first to the third one has two triangles.
Mesh make_kite(double half_length, double half_width) {
  return Mesh({{-half_length, 0, 0}, {0, -half_width, 0}, {half_length, 0, 0}, {0, half_width, 0}},
              {{VertexId(0), VertexId(1), VertexId(2)}, {VertexId(0), VertexId(2), VertexId(3)}});
}

/// The flips of a mesh on a surface.
struct Flipping {
  Flipping(const Mesh& on, const Mesh& flipped)
      : surface(on),
        mesh(flipped),
        tree(surface),
        at_generators(mesh.vertex_count(), Vec3(0, 0, 1)),
        at_faces(mesh.face_count(), Vec3(0, 0, 1)),
        plan{&mesh, IdVector<GeneratorId, CreaseCell>(mesh.vertex_count()),
             std::vector<VertexRole>(mesh.vertex_count(), VertexRole::free),
             std::vector<double>(mesh.vertex_count(), 1)},
        on_curve(mesh.vertex_count(), 0) {}

  std::vector<EdgeFlip> run() const {
    return flip_edges({&surface, &tree, &at_generators, &at_faces, &plan, &on_curve, 0.05, 1, {}}, mesh);
  }

  const Mesh& surface;
  const Mesh& mesh;
  ClosestPointTree tree;
  std::vector<Vec3> at_generators, at_faces;
  SpringPlan plan;
  std::vector<char> on_curve;
};

/// A hexagon round the kite, so that its vertices have more edges.
Mesh surround(const Mesh& kite) {
  std::vector<Vec3> positions = kite.positions();
  std::vector<Face> faces = kite.face_vertices();
  for (int k = 0; k < 4; ++k) {
    const Vec3 &p = kite.position(VertexId(k)), &q = kite.position(VertexId((k + 1) % 4));
    positions.push_back(1.5 * (p + q));
    faces.push_back({VertexId((k + 1) % 4), VertexId(k), VertexId(4 + k)});
  }
  for (int k = 0; k < 4; ++k) faces.push_back({VertexId(k), VertexId(4 + (k + 3) % 4), VertexId(4 + k)});
  return {std::move(positions), std::move(faces)};
}

TEST_CASE("the long diagonal of a kite becomes the short one, unless it follows a curve or its ends are held") {
  const Mesh kite = surround(make_kite(1.5, 1));
  Flipping flipping(kite, kite);
  const std::vector<EdgeFlip> flips = flipping.run();
  REQUIRE(flips.size() == 1);
  CHECK(std::minmax(flips[0].left_apex, flips[0].right_apex) == std::minmax(VertexId(1), VertexId(3)));
  const Mesh after(kite.positions(), apply_flips(kite.face_vertices(), flips));
  CHECK(compute_triangle_quality(after).q_average > compute_triangle_quality(kite).q_average);
  const Mesh before(kite.positions(), undo_flips(after.face_vertices(), flips));
  for (const FaceId f : kite.faces()) {
    Face was = kite.vertices(f), is = before.vertices(f);
    std::sort(was.begin(), was.end());
    std::sort(is.begin(), is.end());
    CHECK(was == is);
  }
  flipping.on_curve[0] = flipping.on_curve[2] = 1;
  CHECK(flipping.run().empty());
  flipping.on_curve[2] = 0;
  flipping.plan.roles[2] = VertexRole::held;
  CHECK(flipping.run().empty());
  flipping.plan.roles[2] = VertexRole::free;
  CHECK(flipping.run().size() == 1);
}

TEST_CASE("no edge is flipped for little, at a vertex with three edges, or to where an edge is") {
  const Mesh nearly = surround(make_kite(1.005, 1));
  CHECK(Flipping(nearly, nearly).run().empty());
  const Mesh bare = make_kite(1.5, 1);  // its ends have three edges
  CHECK(Flipping(bare, bare).run().empty());
  const Mesh tetrahedron = test::make_tetrahedron();  // every two vertices have an edge
  CHECK(Flipping(tetrahedron, tetrahedron).run().empty());
}

TEST_CASE("an edge turns along a ridge, and triangles may not lie across one for better angles") {
  // A roof whose ridge is the kite's long diagonal, as fine as its remesh.
  const auto raise = [](const Mesh& flat) {
    std::vector<Vec3> positions = flat.positions();
    for (Vec3& p : positions) p.z() = -0.7 * std::abs(p.x());
    return with_positions(flat, positions);
  };
  const Mesh ridge = surround(make_kite(1, 1.1));  // the edge from 0 to 2 lies across the ridge
  const Mesh across = raise(ridge);
  const Mesh surface(across.positions(), [&] {
    std::vector<Face> faces = across.face_vertices();
    faces[0] = {VertexId(0), VertexId(1), VertexId(3)};
    faces[1] = {VertexId(1), VertexId(2), VertexId(3)};
    return faces;
  }());
  const std::vector<EdgeFlip> flips = Flipping(surface, across).run();
  REQUIRE(flips.size() == 1);
  CHECK(std::minmax(flips[0].left_apex, flips[0].right_apex) == std::minmax(VertexId(1), VertexId(3)));
  CHECK(Flipping(surface, surface).run().empty());
}

TEST_CASE("remeshes with flips have the input's topology, no flipped and no intersecting triangles, for any threads") {
  std::size_t flips = 0;
  for (const auto& [name, mesh] : test::small_family()) {
    for (const int count : {12, 40}) {
      INFO(name << ", " << count << " generators");
      RemeshOptions options;
      options.diagram.threads = 1;
      const auto generators = test::random_generators(mesh, count, 3);
      const RemeshResult result = remesh(mesh, generators, options);
      CHECK(result.certificate.ok());
      flips += result.flips.size();
      options.diagram.threads = 3;
      const RemeshResult again = remesh(mesh, generators, options);
      CHECK(again.mesh.face_vertices() == result.mesh.face_vertices());
      CHECK(again.mesh.positions() == result.mesh.positions());
      options.placement.method = Placement::generator;
      CHECK(remesh(mesh, generators, options).flips.empty());
    }
  }
  CHECK(flips > 20);
}

TEST_CASE("edges that follow creases are never flipped") {
  const Mesh mesh = test::make_can(48, 1.5);
  RemeshOptions options;
  options.creases = trace_creases(mesh, find_creases(mesh, {40}));
  const RemeshResult result = remesh(mesh, test::random_generators(mesh, 100, 5), options);
  const auto height = [&](VertexId v) {
    const Vec3 p = position(mesh, result.generators[v.index()]);
    return std::hypot(p.x(), p.y()) > 1 - 1e-9 ? p.z() : 10.0 * v.value();  // all rims but one's own differ
  };
  CHECK(result.crease_gap_length == 0);
  CHECK(!result.flips.empty());
  for (const EdgeFlip& flip : result.flips) CHECK(height(flip.from) != height(flip.to));
}

}  // namespace gvd::test_flip_edges
