// Components that are their own triangles, decimated, where the dual of generators is no proper mesh.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "dual/flipped_triangles.hpp"
#include "dual/self_intersections.hpp"
#include "gvd/dual.hpp"
#include "gvd/quality.hpp"
#include "gvd/remesh.hpp"
#include "gvd/sampling.hpp"
#include "gvd/surface_point.hpp"
#include "mesh/component_topology.hpp"
#include "part_distance.hpp"
#include "repair/decimated_components.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_decimated_components {

/// The faces as a mesh, with what stands for its vertices and faces on the surface.
struct Decimated {
  Mesh mesh;
  std::vector<SurfacePoint> generators, face_points;
};

/// `spacing`: of the generators; by default one that limits no edge.
Decimated decimate_all(const Mesh& surface, std::int64_t vertices, double spacing = kInfinity) {
  DecimatedComponents components(surface, spacing);
  std::map<std::int32_t, std::int64_t> all;
  for (const std::int32_t c : components.component()) all[c] = vertices;
  components.add(all);
  components.decimate({});
  Decimated made;
  std::vector<Vec3> positions;
  std::vector<std::array<VertexId, 3>> faces;
  const std::vector<VertexId> kept = components.vertices();
  for (const VertexId v : kept) {
    positions.push_back(surface.position(v));
    made.generators.push_back(vertex_point(surface, v));
  }
  for (const DecimatedFace& face : components.faces()) {
    auto& corners = faces.emplace_back();
    for (int i = 0; i < 3; ++i) {
      corners[i] = VertexId(std::lower_bound(kept.begin(), kept.end(), face.corners[i]) - kept.begin());
    }
    made.face_points.push_back(face.point());
  }
  made.mesh = Mesh(std::move(positions), std::move(faces));
  return made;
}

TEST_CASE("decimated components: as many vertices as asked for, with the topology of the surface") {
  const Decimated sphere = decimate_all(test::make_sphere(3), 20);
  CHECK(sphere.mesh.vertex_count() == 20);
  CHECK(decimate_all(test::make_grid(12, 9), 20).mesh.vertex_count() == 20);
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const Decimated made = decimate_all(mesh, 10);
    CHECK(made.mesh.vertex_count() < mesh.vertex_count());
    CHECK(compute_topologies(made.mesh, compute_face_components(made.mesh)) ==
          compute_topologies(mesh, compute_face_components(mesh)));
  }
}

TEST_CASE("decimated components: down to the fewest vertices that the topology allows") {
  CHECK(decimate_all(test::make_sphere(3), 1).mesh.vertex_count() == 4);
  CHECK(decimate_all(test::make_grid(8, 6), 1).mesh.vertex_count() == 3);
}

TEST_CASE("decimated components: no face is flipped, and none intersects another") {
  for (const auto& [name, mesh] : test::small_family()) {
    for (const std::int64_t vertices : {0, 30}) {
      INFO(name << ", " << vertices);
      const Decimated made = decimate_all(mesh, vertices);
      CHECK(find_flipped_faces(mesh, made.mesh, made.generators, made.face_points).empty());
      for (const FacePair& pair : find_self_intersections(made.mesh)) {
        CHECK(is_surface_triangle(mesh, made.mesh, pair.first, made.generators, made.face_points));
        CHECK(is_surface_triangle(mesh, made.mesh, pair.second, made.generators, made.face_points));
      }
    }
  }
}

TEST_CASE("decimated components: two spheres, one close inside the other, keep apart") {
  const Mesh nested = test::make_nested_spheres(0.98);
  const Decimated made = decimate_all(nested, 8);
  CHECK(find_self_intersections(made.mesh).empty());
  CHECK(made.mesh.vertex_count() < nested.vertex_count());
  CHECK(made.mesh.vertex_count() > 16);
}

TEST_CASE("decimated components: a component that is refined has more vertices each time, in the end its own") {
  const Mesh sphere = test::make_sphere(3);
  DecimatedComponents components(sphere, 10);
  components.add({{0, 8}});
  components.decimate({});
  CHECK(components.vertices().size() == 8);
  std::size_t before = 8;
  for (int times = 0; times < 12; ++times) {
    // Any face of the surface tells the distances; the corners are those of a face as it is now.
    components.refine(sphere, FaceId(0), components.faces().front().corners);
    components.decimate({});
    CHECK(components.vertices().size() >= before);
    before = components.vertices().size();
    if (times == 0) CHECK(before < 100);
  }
  CHECK(std::ssize(components.vertices()) == sphere.vertex_count());
  for (const DecimatedFace& face : components.faces()) CHECK(face.corners == sphere.vertices(face.origin));
}

TEST_CASE("decimated components: edges on curved parts stay within two spacings, with more vertices than asked for") {
  const Mesh sphere = test::make_sphere(4);
  const Decimated coarse = decimate_all(sphere, 20), limited = decimate_all(sphere, 20, 0.2);
  CHECK(coarse.mesh.vertex_count() == 20);
  CHECK(longest_edge(coarse.mesh) > 0.8);
  CHECK(limited.mesh.vertex_count() > 60);
  CHECK(longest_edge(limited.mesh) < 0.5);
}

TEST_CASE("decimated components: flat parts have long edges, whatever the spacing") {
  CHECK(decimate_all(test::make_grid(12, 9), 20, 0.1).mesh.vertex_count() == 20);
}

TEST_CASE("part distance: of a sphere and another one inside, both ways") {
  const Mesh sphere = test::make_sphere(3);
  std::vector<Vec3> positions = sphere.positions();
  for (Vec3& p : positions) p *= 0.9;
  const Mesh smaller(positions, sphere.face_vertices());
  const PartDistance distance = measure_part_distance(sphere, smaller), none = measure_part_distance(sphere, sphere);
  CHECK_THAT(distance.rms, Catch::Matchers::WithinAbs(0.1, 0.002));
  CHECK_THAT(distance.largest, Catch::Matchers::WithinAbs(0.1, 0.002));
  CHECK(none.largest < 1e-12);
  CHECK(none.is_within(distance));
  CHECK_FALSE(distance.is_within(none));
  CHECK_FALSE(PartDistance{1, 3}.is_within({2, 2}));
  CHECK_FALSE(PartDistance{2, 1}.is_within({1, 2}));
}

/// The mesh with a needle of this height and 1e-7 of the width on one of its faces.
Mesh with_needle(const Mesh& mesh, FaceId on, double height) {
  std::vector<Vec3> positions = mesh.positions();
  std::vector<std::array<VertexId, 3>> faces = mesh.face_vertices();
  const std::array<VertexId, 3> outer = mesh.vertices(on);
  const Vec3 middle = (positions[outer[0].index()] + positions[outer[1].index()] + positions[outer[2].index()]) / 3;
  const VertexId first(mesh.vertex_count()), tip(mesh.vertex_count() + 3);
  for (const VertexId v : outer) positions.push_back(middle + 1e-7 * (mesh.position(v) - middle));
  positions.push_back(middle + height * face_normal(mesh, on));
  faces.erase(faces.begin() + on.value());
  for (int i = 0; i < 3; ++i) {
    const VertexId a = outer[i], b = outer[(i + 1) % 3], c(first.value() + i), d(first.value() + (i + 1) % 3);
    faces.insert(faces.end(), {{a, b, d}, {a, d, c}, {c, d, tip}});
  }
  return {std::move(positions), std::move(faces)};
}

/// Remeshes of a mesh that is decimated, with vertices that are placed, and with vertices that stay.
struct Placements {
  RemeshResult placed, held;
};

Placements remesh_twice(const Mesh& mesh, std::int32_t count) {
  SamplingOptions sampling;
  sampling.count = count;
  RemeshOptions options;
  options.may_decimate = true;
  const std::vector<SurfacePoint> generators = sample_generators(mesh, sampling);
  RemeshResult placed = remesh(mesh, generators, options);
  REQUIRE(placed.decimated.components == 1);
  options.placement.method = Placement::generator;
  return {std::move(placed), remesh(mesh, generators, options)};
}

TEST_CASE("remesh: decimated triangles get good shapes, and keep the ends of needles") {
  const auto [result, held] = remesh_twice(with_needle(test::make_sphere(4), FaceId(100), 0.4), 100);
  CHECK(result.certificate.ok());
  CHECK(result.output_quality.q_average > 0.85);
  CHECK(result.input_to_output.hausdorff < 0.2);
  CHECK(result.input_to_output.rms < 0.015);
  CHECK(held.output_quality.q_average < 0.8);
  CHECK(result.input_to_output.rms < held.input_to_output.rms);
}

TEST_CASE("remesh: decimated triangles stay where a fit would take them away from the surface") {
  const auto [result, held] = remesh_twice(with_needle(test::make_plate(8, 0.5), FaceId(10), 0.4), 50);
  CHECK(result.input_to_output.rms <= held.input_to_output.rms);
  CHECK(result.output_to_input.rms <= held.output_to_input.rms);
}

TEST_CASE("remesh: a spike too narrow for generators keeps its own triangles, decimated") {
  const Mesh spike = test::make_pyramid(1e-3, 5);
  const SurfacePoint near_tip = make_surface_point(FaceId(0), {0.9, 0.03, 0.07});
  RemeshOptions options;
  options.may_decimate = true;
  const RemeshResult result =
      remesh(spike, {vertex_point(spike, VertexId(0)), near_tip, vertex_point(spike, VertexId(6))}, options);
  CHECK(result.certificate.ok());
  CHECK(result.decimated.components == 1);
  CHECK(result.decimated.generators == 3);
  CHECK(result.decimated.vertices == result.mesh.vertex_count());
  CHECK_THAT(result.decimated.reason, Catch::Matchers::Contains("near ("));
}

/// A closed hose round the z axis, whose cells are rings until there are many.
Mesh make_hose(int around, int across, double width) {
  std::vector<Vec3> positions;
  std::vector<std::array<VertexId, 3>> faces;
  const auto at = [&](int i, int j) { return VertexId((i % around) * across + j % across); };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double u = 2 * std::acos(-1.0) * i / around, v = 2 * std::acos(-1.0) * j / across;
      const double radius = 1 + width * std::cos(v);
      positions.emplace_back(radius * std::cos(u), radius * std::sin(u), width * std::sin(v));
      faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return {std::move(positions), std::move(faces)};
}

TEST_CASE("remesh: what a few rounds repair is not decimated, however many defects it has") {
  const Mesh hose = make_hose(1200, 10, 0.005);
  std::vector<SurfacePoint> along;
  for (int i = 0; i < 60; ++i) along.push_back(vertex_point(hose, VertexId(200 * i + i % 10)));
  RemeshOptions options;
  options.may_decimate = true;
  const RemeshResult result = remesh(hose, along, options);
  CHECK(result.given_defects.size() > 90);
  CHECK(result.decimated.components == 0);
  CHECK(result.added > 60);
}

/// Both meshes as components of one.
Mesh join(const Mesh& first, const Mesh& second) {
  std::vector<Vec3> positions = first.positions();
  std::vector<std::array<VertexId, 3>> faces = first.face_vertices();
  positions.insert(positions.end(), second.positions().begin(), second.positions().end());
  const std::int32_t n = first.vertex_count();
  for (const auto& [a, b, c] : second.face_vertices()) {
    faces.push_back({VertexId(n + a.value()), VertexId(n + b.value()), VertexId(n + c.value())});
  }
  return {std::move(positions), std::move(faces)};
}

/// "2: 1, 3: 4" for one component by the cause of number 2 and four by that of number 3.
std::string causes_of(const RemeshResult& result) {
  std::string causes;
  for (const auto& [cause, count] : result.decimated.causes) {
    causes += fmt::format("{}{}: {}", causes.empty() ? "" : ", ", int(cause), count);
  }
  return causes;
}

/// The mesh, moved and scaled; with a negative factor turned inside out.
Mesh placed(const Mesh& mesh, double factor, const Vec3& offset) {
  std::vector<Vec3> positions;
  for (const Vec3& p : mesh.positions()) positions.push_back(std::abs(factor) * p + offset);
  std::vector<std::array<VertexId, 3>> faces = mesh.face_vertices();
  if (factor < 0) {
    for (auto& face : faces) std::swap(face[1], face[2]);
  }
  return {std::move(positions), std::move(faces)};
}

TEST_CASE("remesh: a component of an assembly that takes too many generators is decimated, the others are not") {
  const Mesh hose = make_hose(300, 8, 0.02);
  Mesh assembly = join(hose, test::make_sphere(2));
  std::vector<SurfacePoint> generators{vertex_point(assembly, VertexId(0)), vertex_point(assembly, VertexId(1200))};
  for (int i = 0; i < 80; ++i) generators.push_back(vertex_point(assembly, VertexId(hose.vertex_count() + 2 * i)));
  for (int part = 0; part < 7; ++part) {
    const std::int32_t first = assembly.vertex_count();
    assembly = join(assembly, placed(test::make_sphere(1), 0.1, Vec3(10, part, 10)));
    for (int i = 0; i < 12; ++i) generators.push_back(vertex_point(assembly, VertexId(first + i)));
  }
  RemeshOptions options;
  options.may_decimate = true;
  const RemeshResult result = remesh(assembly, generators, options);
  CHECK(result.certificate.ok());
  CHECK(causes_of(result) == "2: 1");
  CHECK(result.decimated.generators == 2);
  CHECK(result.decimated.vertices < 60);
  CHECK(result.mesh.vertex_count() < result.decimated.vertices + 90 + 7 * 12);
}

TEST_CASE("remesh: the two sides of a thin hollow body are repaired, and not decimated") {
  const Mesh shell = join(test::make_sphere(3), placed(test::make_sphere(3), -0.97, Vec3::Zero()));
  SamplingOptions sampling;
  sampling.count = 60;
  RemeshOptions options;
  options.may_decimate = true;
  const RemeshResult result = remesh(shell, sample_generators(shell, sampling), options);
  CHECK(result.certificate.ok());
  CHECK(result.decimated.components == 0);
}

/// A sphere of which one vertex is the tip of a spike too narrow for generators. The tip is vertex 0.
Mesh make_spiked_sphere() {
  const Mesh sphere = test::make_sphere(3);
  std::vector<Vec3> positions = sphere.positions();
  const Vec3& axis = sphere.position(VertexId(0));
  for (const HalfedgeId h : sphere.halfedges()) {
    if (sphere.from(h) != VertexId(0)) continue;
    const Vec3& at = sphere.position(sphere.to(h));
    positions[sphere.to(h).index()] = axis + 1e-6 * (at - axis * axis.dot(at)).normalized();
  }
  positions[0] = 2 * axis;
  return {std::move(positions), sphere.face_vertices()};
}

TEST_CASE("remesh: a decimated component gets vertices back until it does not meet the dual of another one") {
  const Mesh outer = make_spiked_sphere();
  const Mesh sphere = test::make_sphere(3);
  std::vector<Vec3> smaller;
  for (const Vec3& p : sphere.positions()) smaller.push_back(0.75 * p);
  const Mesh both = join(outer, Mesh(std::move(smaller), outer.face_vertices()));
  std::vector<SurfacePoint> generators{vertex_point(both, VertexId(0))};
  for (int i = 1; i < 8; ++i) generators.push_back(vertex_point(both, VertexId(80 * i)));
  for (int i = 0; i < 40; ++i) generators.push_back(vertex_point(both, VertexId(outer.vertex_count() + 16 * i)));
  RemeshOptions options;
  options.may_decimate = true;
  const RemeshResult result = remesh(both, generators, options);
  CHECK(result.certificate.ok());
  CHECK(result.certificate.self_intersections.empty());
  CHECK(result.decimated.causes.at(DecimationCause::narrow_tip) == 1);
  CHECK(result.decimated.vertices > 2 * decimate_all(outer, 8).mesh.vertex_count());
}

}  // namespace gvd::test_decimated_components
