// The certificate: each property fails on a mesh that lacks it.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include "gvd/remesh.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_certify_remesh {

Diagram only_generators(std::vector<SurfacePoint> generators) {
  Diagram diagram;
  diagram.generators = std::move(generators);
  return diagram;
}

/// The remesh of a mesh by itself: its vertices are the generators, and a point of each face its branch point.
struct Copy {
  Mesh surface;
  std::vector<SurfacePoint> generators, face_points;

  explicit Copy(Mesh mesh) : surface(std::move(mesh)) {
    for (int v = 0; v < surface.vertex_count(); ++v) generators.push_back(vertex_point(surface, VertexId(v)));
    for (int f = 0; f < surface.face_count(); ++f) {
      face_points.push_back(make_surface_point(FaceId(f), {0.25, 0.25, 0.5}));
    }
  }
  std::vector<std::array<VertexId, 3>> faces() const {
    std::vector<std::array<VertexId, 3>> result;
    for (int f = 0; f < surface.face_count(); ++f) result.push_back(surface.vertices(FaceId(f)));
    return result;
  }
  RemeshCertificate certify(const std::vector<std::array<VertexId, 3>>& faces) const {
    return certify_remesh(surface, only_generators(generators), Mesh(surface.positions(), faces), face_points);
  }
};

TEST_CASE("certificate: nothing holds by default") {
  const RemeshCertificate empty;
  CHECK_FALSE(empty.ok());
  CHECK(empty.first_failure() == "it is not a manifold");
}

TEST_CASE("certificate: every mesh is a remesh of itself") {
  for (const auto& [name, mesh] : test::small_family()) {
    if (name == "thin-faced sphere") continue;  // its faces fold back: flipped against the mean of the normals
    CAPTURE(name);
    const Copy copy(mesh);
    CHECK(copy.certify(copy.faces()).first_failure() == "");
  }
}

TEST_CASE("certificate: a missing face opens a closed mesh") {
  const Copy copy(test::make_sphere(1));
  auto faces = copy.faces();
  faces.pop_back();
  const RemeshCertificate c = copy.certify(faces);
  CHECK(c.manifold);
  CHECK_FALSE(c.closed_as_input);
  CHECK_FALSE(c.same_euler_characteristic);
  CHECK_FALSE(c.same_boundary_loops);
  CHECK(c.same_components);
  CHECK_FALSE(c.same_in_each_component);
  CHECK(c.first_failure() == "it has a boundary and the input has none, or the other way round");
}

TEST_CASE("certificate: reversed faces are flipped") {
  const Copy copy(test::make_tetrahedron());
  auto faces = copy.faces();
  for (auto& f : faces) std::swap(f[0], f[1]);
  const RemeshCertificate c = copy.certify(faces);
  CHECK(c.flipped_faces == 4);
  CHECK(c.first_failure() == "faces are flipped: 4");
}

TEST_CASE("certificate: a generator without a face is counted") {
  const Copy copy(test::make_tetrahedron());
  auto generators = copy.generators;
  generators.push_back(make_surface_point(FaceId(0), {0.2, 0.3, 0.5}));
  const RemeshCertificate c = certify_remesh(copy.surface, only_generators(generators), copy.surface, copy.face_points);
  CHECK(c.unused_generators == 1);
  CHECK(c.first_failure() == "generators are not used: 1");
}

TEST_CASE("certificate: as many components, but one of them with generators of both") {
  // Two triangles; the remesh has two as well, with one vertex of each exchanged.
  const Copy copy(
      test::make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}}, {{0, 1, 2}, {3, 4, 5}}));
  CHECK(copy.certify(copy.faces()).ok());
  auto exchanged = copy.faces();
  std::swap(exchanged[0][1], exchanged[1][1]);
  const RemeshCertificate c = copy.certify(exchanged);
  CHECK(c.same_euler_characteristic);
  CHECK_FALSE(c.same_components);
  CHECK(c.first_failure() == "its components are not those of the input");
}

TEST_CASE("certificate: sums agree, but not the components by themselves") {
  // The surface: a disc and a sphere with one hole more each way. Euler characteristics 1 + 0 against 0 + 1.
  const Mesh ring = test::make_ring(6, 1), disc = test::make_grid(2, 2);
  const auto both = [](const Mesh& a, const Mesh& b) {
    std::vector<Vec3> positions = a.positions();
    for (const Vec3& p : b.positions()) positions.push_back(p + Vec3(10, 0, 0));
    std::vector<std::array<VertexId, 3>> faces;
    for (int f = 0; f < a.face_count(); ++f) faces.push_back(a.vertices(FaceId(f)));
    for (int f = 0; f < b.face_count(); ++f) {
      auto face = b.vertices(FaceId(f));
      for (VertexId& v : face) v = VertexId(v.value() + a.vertex_count());
      faces.push_back(face);
    }
    return Mesh(std::move(positions), std::move(faces));
  };
  const Mesh surface = both(ring, disc), remeshed = both(disc, ring);
  // The remesh's first component, a disc, has its generators on the surface's first one, a ring; and the other way.
  std::vector<SurfacePoint> generators;
  for (int v = 0; v < remeshed.vertex_count(); ++v) {
    const bool first = v < disc.vertex_count();
    generators.push_back(vertex_point(surface, VertexId(first ? v : ring.vertex_count() + v % disc.vertex_count())));
  }
  const std::vector<SurfacePoint> face_points(static_cast<std::size_t>(remeshed.face_count()),
                                              make_surface_point(FaceId(0), {0.25, 0.25, 0.5}));
  const RemeshCertificate c = certify_remesh(surface, only_generators(generators), remeshed, face_points);
  CHECK(c.same_components);
  CHECK(c.same_euler_characteristic);
  CHECK(c.same_boundary_loops);
  CHECK_FALSE(c.same_in_each_component);
}

TEST_CASE("certificate: faces that intersect fail, unless they are allowed") {
  // The torus is moved to the centre of the sphere, which it then crosses.
  const Copy copy(test::make_two_components());
  std::vector<Vec3> positions = copy.surface.positions();
  const IdVector<FaceId, std::int32_t> component = compute_face_components(copy.surface);
  std::vector<char> moved(positions.size(), 0);
  for (int f = 0; f < copy.surface.face_count(); ++f) {
    if (component[FaceId(f)] == 0) continue;
    for (const VertexId v : copy.surface.vertices(FaceId(f))) moved[v.index()] = 1;
  }
  Vec3 first(0, 0, 0), second(0, 0, 0);  // sums of the vertices of the two
  for (std::size_t i = 0; i < positions.size(); ++i) (moved[i] ? second : first) += positions[i];
  const auto count = std::count(moved.begin(), moved.end(), 1);
  const Vec3 shift = first / static_cast<double>(std::ssize(moved) - count) - second / static_cast<double>(count);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (moved[i]) positions[i] += shift;
  }
  const Mesh crossed(positions, copy.faces());
  RemeshCertificate c = certify_remesh(copy.surface, only_generators(copy.generators), crossed, copy.face_points);
  CHECK(c.self_intersections.size() > 10);
  CHECK(c.inherited_intersections == 0);
  CHECK(c.first_failure().find("pairs of its faces intersect: ") == 0);
  c.intersections_allowed = true;
  CHECK(c.ok());
  const Diagram diagram = compute_diagram(crossed, copy.generators);
  const RemeshCertificate inherited = certify_remesh(crossed, diagram, crossed, copy.face_points);
  CHECK(inherited.self_intersections == c.self_intersections);
  CHECK(inherited.inherited_intersections == std::ssize(c.self_intersections));
  CHECK(inherited.ok());
}

}  // namespace gvd::test_certify_remesh
