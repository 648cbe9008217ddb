// The remesher on the mesh families: certified, or refused in clear words.
#if defined(__GNUC__) && !defined(__clang__)
// OpenMesh's vectors begin uninitialised; the warning comes where its templates are instantiated, at the end of this
// file.
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <algorithm>
#include <set>
#include <string>

#include "gvd/check.hpp"
#include "gvd/closest_point.hpp"
#include "gvd/error.hpp"
#include "gvd/openmesh.hpp"
#include "gvd/remesh.hpp"
#include "gvd/remesh_map.hpp"
#include "gvd/remesh_scenes.hpp"
#include "gvd/sampling.hpp"
#include "remesh/dual_defects.hpp"
#include "remesh/remesh_refusal.hpp"
#include "repair/added_generators.hpp"
#include "support/cancelled.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/sanitized.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_remesh {

/// Counts what the certificate promises once more, from the triangles alone.
void require_same_topology(const Mesh& input, const Mesh& output) {
  const MeshSummary in = compute_mesh_summary(input), out = compute_mesh_summary(output);
  CHECK(in.components == out.components);
  CHECK(in.boundary_loops == out.boundary_loops);
  CHECK(in.euler_characteristic == out.euler_characteristic);
}

void require_generators_kept(const std::vector<SurfacePoint>& given, const RemeshResult& result) {
  REQUIRE(result.generators.size() == given.size() + static_cast<std::size_t>(result.added));
  REQUIRE(result.mesh.vertex_count() == static_cast<std::int32_t>(result.generators.size()));
  for (std::size_t i = 0; i < given.size(); ++i) CHECK(result.generators[i] == given[i]);
}

RemeshResult require_remesh(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                            const RemeshOptions& options = {}) {
  RemeshResult result = remesh(mesh, generators, options);
  CHECK(result.certificate.first_failure() == "");
  CHECK(check_diagram(mesh, result.diagram).ok());
  CHECK(test::find_dual_defects(mesh, result.diagram).empty());
  require_same_topology(mesh, result.mesh);
  require_generators_kept(generators, result);
  return result;
}

TEST_CASE("remesh: a certified mesh on every family, from one generator to a hundred") {
  for (const auto& [name, mesh] : test::small_family()) {
    for (const int count : test::thinned({1, 2, 3, 4, 5, 10, 30, 100})) {
      INFO(name << ", " << count << " generators");
      require_remesh(mesh, test::random_generators(mesh, count, 0));
    }
  }
}

TEST_CASE("remesh: no more rounds than generators may be added, and one") {
  int ended = 0, refused = 0;
  for (const auto& [name, mesh] : test::small_family()) {
    for (const std::int64_t most : test::thinned({0, 1, 2, 5, 9})) {
      INFO(name << ", " << most);
      RemeshOptions options;
      options.max_added = most;
      try {
        const RemeshResult result = remesh(mesh, test::random_generators(mesh, 10, 2), options);
        CHECK(result.rounds <= most + 1);
        ++ended;
      } catch (const Error& error) {
        CHECK(error.code() == ErrorCode::no_valid_result);
        ++refused;
      }
    }
  }
  CHECK(ended > 0);
  CHECK(refused > 0);
}

TEST_CASE("remesh: planar fronts") {
  RemeshOptions options;
  options.diagram.method = Method::gbgvd;
  options.diagram.front = Front::planar;
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    require_remesh(mesh, test::random_generators(mesh, 10, 1), options);
  }
}

TEST_CASE("remesh: one, two or three generators on a sphere are completed to a closed mesh") {
  const Mesh mesh = test::make_sphere(3);
  for (const int count : {1, 2, 3}) {
    const RemeshResult result = require_remesh(mesh, test::random_generators(mesh, count, 5));
    CHECK(result.added >= 4 - count);
    CHECK(result.added <= 8);
  }
}

TEST_CASE("remesh: a handle and a boundary loop get three vertices each way") {
  const Mesh torus = test::make_torus(24, 12);
  const RemeshResult around = require_remesh(torus, test::random_generators(torus, 2, 1));
  CHECK(around.mesh.vertex_count() >= 7);  // no torus has fewer
  const Mesh ring = test::make_ring(24, 6);
  const RemeshResult open = require_remesh(ring, test::random_generators(ring, 1, 1));
  CHECK(open.certificate.output.boundary_loops == 2);
  CHECK(open.mesh.vertex_count() >= 6);
}

TEST_CASE("remesh: components without a generator get some") {
  const Mesh mesh = test::make_two_components();
  const RemeshResult result = require_remesh(mesh, {vertex_point(mesh, VertexId(0))});
  CHECK(result.certificate.output.components == 2);
  CHECK(result.certificate.same_in_each_component);
}

TEST_CASE("remesh: components may touch: a generator of one is not too close to those of another") {
  const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {-1, 0, 0}, {0, -1, 0}};
  const Mesh mesh(corners, {{VertexId(0), VertexId(1), VertexId(2)}, {VertexId(3), VertexId(4), VertexId(5)}});
  const RemeshResult result = require_remesh(mesh, {vertex_point(mesh, VertexId(0))});
  CHECK(result.certificate.output.components == 2);
}

TEST_CASE("remesh: generators on both sides of a slit, at the same position") {
  std::vector<Vec3> corners{{0, 0, 0}};
  for (const auto& [x, y] : std::vector<std::pair<int, int>>{{2, 0}, {1, 2}, {-1, 2}, {-2, 0}, {-1, -2}, {1, -2}}) {
    corners.emplace_back(x, y, 0);
  }
  corners.push_back(corners[1]);
  std::vector<std::array<VertexId, 3>> faces;
  for (int i = 1; i <= 6; ++i) faces.push_back({VertexId(0), VertexId(i), VertexId(i + 1)});
  const Mesh mesh(corners, faces);
  // The bisector of the first two begins at the slit's inner end and meets the cell of vertex 4: a triangle with an
  // edge of length 0.
  std::vector<SurfacePoint> generators{edge_point(Mesh::halfedge(FaceId(0), 0), 0.5),
                                       edge_point(Mesh::halfedge(FaceId(5), 2), 0.5)};
  REQUIRE(position(mesh, generators[0]) == position(mesh, generators[1]));
  for (const int v : {4, 2, 6}) generators.push_back(vertex_point(mesh, VertexId(v)));
  require_remesh(mesh, generators);
}

TEST_CASE("remesh: a tube cut open along a seam, with generators that coincide in space on the two banks") {
  const Mesh tube = test::make_cut_tube(4, 1, 20);
  // The generators' cells reach the other bank opposite to themselves, so that a new one has to lie there.
  const RemeshResult result = require_remesh(tube, {vertex_point(tube, VertexId(2)), vertex_point(tube, VertexId(3))});
  CHECK(result.certificate.output.boundary_loops == 1);
  std::size_t in_one_place = 0;
  const auto& points = result.generators;
  const double spacing = kMinAddedSpacing * tube.bbox_diagonal();
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      CHECK_FALSE(are_near(tube, points[i], points[j], spacing));
      if ((position(tube, points[i]) - position(tube, points[j])).norm() <= spacing) ++in_one_place;
    }
  }
  CHECK(in_one_place > 0);
}

TEST_CASE("remesh: tips of 40 degrees and less do not attract ever more generators") {
  for (const double angle : {40, 30, 25, 10, 1}) {
    for (const int count : {4, 8, 20}) {
      CAPTURE(angle, count);
      const Mesh mesh = test::make_pyramid(angle, 5);
      SamplingOptions farthest;
      farthest.count = count;
      const RemeshResult result = require_remesh(mesh, sample_generators(mesh, farthest));
      CHECK(result.added <= 2 * count + 8);
      CHECK(result.rounds <= 20);
    }
  }
}

TEST_CASE("remesh: where a spike is too narrow, the reason names its tip and its angle, and what helps") {
  const auto reason = [](double angle) {
    const Mesh spike = test::make_pyramid(angle, 5);
    const SurfacePoint near_tip = make_surface_point(FaceId(0), {0.9, 0.03, 0.07});
    return std::string(
        test::remesh_refusal(spike, {vertex_point(spike, VertexId(0)), near_tip, vertex_point(spike, VertexId(6))}, {})
            .what());
  };
  CHECK_THAT(reason(1e-3), Catch::Matchers::Contains("the total angle of vertex 0 at (0, 0, 1) is 0.001 degrees"));
  CHECK_THAT(reason(1e-3), Catch::Matchers::Contains("no generator may be nearer to it than 0.172; choose others"));
  CHECK_THAT(reason(1e-5), Catch::Matchers::Contains("is 1e-05 degrees"));
  CHECK_THAT(reason(1e-5), Catch::Matchers::Contains("cut the surface off there"));
}

TEST_CASE("remesh: the tip of a flat spike, front and back") {
  for (const double angle : {40, 25}) {
    CAPTURE(angle);
    const Mesh wedge = test::make_pyramid(angle, 2);
    for (unsigned seed = 0; seed < 3; ++seed) require_remesh(wedge, test::random_generators(wedge, 5, seed));
  }
}

TEST_CASE("remesh: many generators in one face") {
  const Mesh triangle({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {{VertexId(0), VertexId(1), VertexId(2)}});
  require_remesh(triangle, {vertex_point(triangle, VertexId(0))});
  require_remesh(triangle, {make_surface_point(FaceId(0), {0.3, 0.3, 0.4})});
  std::vector<SurfacePoint> row;
  for (int i = 1; i < 9; ++i) row.push_back(make_surface_point(FaceId(0), {0.3, 0.07 * i, 0.7 - 0.07 * i}));
  require_remesh(triangle, row);
}

TEST_CASE("remesh: generators in a tight cluster, and all on the boundary") {
  const Mesh sphere = test::make_sphere(3);
  std::vector<SurfacePoint> cluster;
  for (int i = 1; i <= 6; ++i) cluster.push_back(make_surface_point(FaceId(7), {0.1 * i, 0.2, 0.8 - 0.1 * i}));
  require_remesh(sphere, cluster);
  const Mesh grid = test::make_grid(6, 6);
  std::vector<SurfacePoint> border;
  for (std::int32_t v = 0; v < grid.vertex_count(); ++v) {
    if (grid.is_boundary(VertexId(v))) border.push_back(vertex_point(grid, VertexId(v)));
  }
  const RemeshResult result = require_remesh(grid, border);
  CHECK(result.certificate.output.area == Approx(36));
}

TEST_CASE("remesh: refuses where no generator may be added, and names property and position") {
  const Mesh sphere = test::make_sphere(2);
  RemeshOptions options;
  options.refine = false;
  const Error error = test::remesh_refusal(sphere, test::random_generators(sphere, 2, 0), options);
  CHECK(error.code() == ErrorCode::no_valid_result);
  CHECK_THAT(error.what(), Catch::Matchers::Contains("(4) cells 0 and 1 share a closed bisector, near ("));
  const auto thirty = test::random_generators(sphere, 30, 0);
  const RemeshResult enough = remesh(sphere, thirty, options);
  CHECK(enough.added == 0);
  CHECK(enough.given_defects.empty());
}

TEST_CASE("remesh: refuses where more generators are needed than may be added") {
  const Mesh torus = test::make_torus(24, 12);
  RemeshOptions options;
  options.max_added = 2;
  const Error error = test::remesh_refusal(torus, {vertex_point(torus, VertexId(0))}, options);
  CHECK(error.code() == ErrorCode::no_valid_result);
  CHECK_THAT(error.what(), Catch::Matchers::Contains("the dual of 3 generators is no valid mesh: (2)"));
  CHECK_THAT(error.what(), Catch::Matchers::Contains("2 generators were added"));
  options.max_added = -1;
  CHECK(test::remesh_refusal(torus, {vertex_point(torus, VertexId(0))}, options).code() == ErrorCode::invalid_option);
}

TEST_CASE("remesh: exactly as many vertices as asked for, with the first generators in their places") {
  std::int64_t exchanged = 0, filled = 0;
  int runs = 0, successes = 0;
  for (const auto& [name, mesh] : test::small_family()) {
    for (const auto& [count, more] : {std::pair(40, 0), std::pair(40, 3), std::pair(8, 10)}) {
      INFO(name << ", " << count << " and " << more << " more");
      const auto given = test::random_generators(mesh, count, 4);
      ++runs;
      RemeshOptions options;
      options.vertex_count = std::ssize(given) + more;
      options.kept = 5;
      try {
        const RemeshResult result = remesh(mesh, given, options);
        CHECK(result.certificate.first_failure() == "");
        CHECK(result.mesh.vertex_count() == *options.vertex_count);
        CHECK(std::equal(given.begin(), given.begin() + 5, result.generators.begin()));
        CHECK(std::ssize(given) + result.added - result.left_out == *options.vertex_count);
        ++successes;
        exchanged += result.left_out;
        filled += more > 0 && result.added > 0;
      } catch (const Error& error) {
        CHECK(error.code() == ErrorCode::no_valid_result);
        CHECK_THAT(error.what(), Catch::Matchers::Contains(": the search ended at "));
      }
    }
  }
  CAPTURE(successes, runs);
  CHECK(4 * successes >= 3 * runs);
  CHECK(exchanged > 0);
  CHECK(filled > 0);
}

TEST_CASE("remesh: what can't have so few vertices is refused, and how few it came to is told") {
  const Mesh torus = test::make_torus(24, 12);
  RemeshOptions options;
  options.vertex_count = 4;
  const Error error = test::remesh_refusal(torus, test::random_generators(torus, 4, 1), options);
  CHECK(error.code() == ErrorCode::no_valid_result);
  CHECK_THAT(error.what(), Catch::Matchers::Contains("no valid mesh of 4 vertices was found: "));
}

/// Generators on a flat square, two of them near each other in its middle.
std::vector<SurfacePoint> make_close_pair(const Mesh& grid, double distance) {
  const ClosestPointTree surface(grid);
  std::vector<SurfacePoint> points;
  for (std::int32_t v = 0; v < grid.vertex_count(); ++v) {
    if ((grid.position(VertexId(v)) - Vec3(3, 3, 0)).norm() > 1.5) points.push_back(vertex_point(grid, VertexId(v)));
  }
  for (const double x : {-0.5, 0.5}) points.push_back(surface.query({3 + x * distance, 3 + x * distance / 7, 0}).point);
  return points;
}

TEST_CASE("remesh: slivers are repaired where that helps, and named elsewhere") {
  const Mesh grid = test::make_grid(6, 6);
  RemeshOptions options;
  options.placement.method = Placement::generator;
  const RemeshResult repaired = require_remesh(grid, make_close_pair(grid, 1e-3), options);
  CHECK(repaired.slivers.empty());
  CHECK(repaired.added > 0);
  options.refine = false;
  const RemeshResult named = remesh(grid, make_close_pair(grid, 1e-3), options);
  CHECK(named.slivers.size() == 2);
  CHECK(named.added == 0);
}

TEST_CASE("remesh: two runs give the same bytes") {
  const Mesh mesh = test::make_genus3(3);
  const auto generators = test::random_generators(mesh, 5, 2);
  const RemeshResult first = remesh(mesh, generators), second = remesh(mesh, generators);
  CHECK(first.generators == second.generators);
  REQUIRE(first.mesh.face_count() == second.mesh.face_count());
  for (std::int32_t f = 0; f < first.mesh.face_count(); ++f) {
    CHECK(first.mesh.vertices(FaceId(f)) == second.mesh.vertices(FaceId(f)));
  }
}

TEST_CASE("remesh: a known diagram gives the same mesh, and is not computed again") {
  const Mesh mesh = test::make_torus(24, 12);
  for (const int count : {3, 60}) {  // three need more of them, and so more diagrams
    CAPTURE(count);
    const auto generators = test::random_generators(mesh, count, 2);
    int diagrams = 0;
    RemeshOptions options;
    options.on_stage = [&diagrams](RemeshStage stage) { diagrams += stage == RemeshStage::diagram; };
    const RemeshResult known = remesh(mesh, compute_diagram(mesh, generators, options.diagram), options);
    CHECK(diagrams == known.rounds - 1);
    const RemeshResult computed = remesh(mesh, generators, options);
    CHECK(known.rounds == computed.rounds);
    CHECK(known.added == computed.added);
    CHECK(known.mesh.positions() == computed.mesh.positions());
    CHECK(known.face_points == computed.face_points);
  }
}

TEST_CASE("remesh: a known diagram of another mesh is refused, and wrong options are") {
  const Mesh mesh = test::make_torus(24, 12), other = test::make_sphere(2);
  const Diagram diagram = compute_diagram(mesh, test::random_generators(mesh, 9, 2));
  CHECK(test::remesh_refusal(other, diagram).code() == ErrorCode::precondition);
  CHECK(test::remesh_refusal(mesh, Diagram()).code() == ErrorCode::precondition);
  RemeshOptions wrong;
  wrong.max_added = -1;
  CHECK(test::remesh_refusal(mesh, diagram, wrong).code() == ErrorCode::invalid_option);
}

TEST_CASE("remesh: progress can cancel") {
  const Mesh mesh = test::make_sphere(2);
  RemeshOptions options;
  options.diagram.progress = [](std::string_view, double) { return false; };
  CHECK(test::remesh_refusal(mesh, test::random_generators(mesh, 5, 0), options).code() == ErrorCode::interrupted);
}

TEST_CASE("remesh: progress tells of the placement and the distance, too") {
  const Mesh mesh = test::make_sphere(2);
  RemeshOptions options;
  std::set<std::string> steps;
  options.diagram.progress = [&](std::string_view step, double) {
    steps.emplace(step);
    return true;
  };
  remesh(mesh, test::random_generators(mesh, 12, 0), options);
  CHECK(steps.contains("placement"));
  CHECK(steps.contains("distance"));
}

TEST_CASE("remesh: the certificate does not hold for another mesh") {
  const Mesh sphere = test::make_sphere(2);
  const RemeshResult good = remesh(sphere, test::random_generators(sphere, 12, 0));
  const auto certify = [&](const Mesh& output) {
    return certify_remesh(sphere, good.diagram, output, good.face_points);
  };
  std::vector<std::array<VertexId, 3>> faces;
  for (std::int32_t f = 0; f < good.mesh.face_count(); ++f) faces.push_back(good.mesh.vertices(FaceId(f)));
  CHECK(certify(Mesh(good.mesh.positions(), faces)).ok());

  auto inside_out = faces;
  for (auto& face : inside_out) std::swap(face[0], face[1]);
  CHECK(certify(Mesh(good.mesh.positions(), inside_out)).flipped_faces == good.mesh.face_count());

  auto open = faces;
  open.pop_back();
  const RemeshCertificate torn = certify(Mesh(good.mesh.positions(), open));
  CHECK(!torn.closed_as_input);
  CHECK(!torn.same_boundary_loops);
  CHECK(!torn.same_euler_characteristic);
  CHECK(torn.manifold);
  CHECK(!torn.ok());
  CHECK_THAT(torn.first_failure(), Catch::Matchers::Contains("has a boundary"));
}

TEST_CASE("openmesh: a mesh goes there and comes back bit by bit") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const OpenMeshTriMesh peer = to_openmesh(mesh);
    CHECK(peer.n_vertices() == static_cast<std::size_t>(mesh.vertex_count()));
    CHECK(peer.n_edges() == static_cast<std::size_t>(mesh.edge_count()));
    const Mesh back = from_openmesh(peer);
    CHECK(back.positions() == mesh.positions());
    REQUIRE(back.face_count() == mesh.face_count());
    bool same = true;
    for (std::int32_t f = 0; f < mesh.face_count(); ++f) same &= back.vertices(FaceId(f)) == mesh.vertices(FaceId(f));
    CHECK(same);
  }
}

TEST_CASE("openmesh: deleted faces and lone vertices stay behind") {
  OpenMeshTriMesh peer = to_openmesh(test::make_grid(3, 2));
  peer.request_vertex_status();
  peer.request_edge_status();
  peer.request_face_status();
  peer.add_vertex({9, 9, 9});
  peer.delete_face(OpenMesh::FaceHandle(0), true);
  const Mesh back = from_openmesh(peer);
  CHECK(back.face_count() == 11);
  CHECK(back.bbox_diagonal() < 4);
}

// Twelve vertices on a sphere of radius 1 make triangles whose middles are at .8 at best: they enter a sphere of .85.
TEST_CASE("remesh: triangles that intersect get more generators, unless they are allowed") {
  RemeshOptions allow, refine;
  allow.placement.method = refine.placement.method = Placement::generator;
  allow.allow_intersections = true;
  const Mesh mesh = test::make_nested_spheres(0.85);
  for (const unsigned seed : test::thinned({0u, 1u})) {
    INFO("seed " << seed);
    const auto generators = test::random_generators(mesh, 24, seed);
    const RemeshResult before = remesh(mesh, generators, allow);
    CHECK(before.certificate.ok());
    CHECK_FALSE(before.certificate.self_intersections.empty());
    const RemeshResult after = require_remesh(mesh, generators, refine);
    CHECK(after.certificate.self_intersections.empty());
    CHECK(after.added > before.added);
    CHECK(require_remesh(mesh, generators).certificate.self_intersections.empty());
  }
}

TEST_CASE("remesh: the vertices are at the generators, bit by bit, where placement asks for it") {
  RemeshOptions options;
  options.placement.method = Placement::generator;
  const Mesh mesh = test::make_bumpy_sphere(3, 2);
  const RemeshResult result = require_remesh(mesh, test::random_generators(mesh, 60, 1), options);
  for (std::size_t i = 0; i < result.generators.size(); ++i) {
    CHECK(result.mesh.positions()[i] == position(mesh, result.generators[i]));
  }
}

TEST_CASE("remesh: placed vertices bring the mesh nearer to the surface, and it is certified") {
  const Mesh mesh = test::make_bumpy_sphere(4, 2);
  const auto generators = test::random_generators(mesh, 100, 1);
  std::vector<double> rms;
  for (const Placement method : {Placement::generator, Placement::quadric, Placement::fit}) {
    RemeshOptions options;
    options.placement.method = method;
    const RemeshResult result = require_remesh(mesh, generators, options);
    rms.push_back(std::max(result.input_to_output.rms, result.output_to_input.rms));
  }
  CHECK(rms[1] < 0.75 * rms[0]);
  CHECK(rms[2] < 0.75 * rms[1]);
}

TEST_CASE(
    "a remesh announces its stages in turn, a diagram and its dual in every round, then placement, search and "
    "distances") {
  const Mesh mesh = test::make_torus(24, 12);
  RemeshOptions options;
  std::vector<RemeshStage> stages;
  options.on_stage = [&stages](RemeshStage stage) { stages.push_back(stage); };
  const RemeshResult result = remesh(mesh, test::random_generators(mesh, 2, 1), options);
  CHECK(result.rounds > 1);
  REQUIRE(stages.size() == 2 * static_cast<std::size_t>(result.rounds) + 3);
  CHECK(stages[stages.size() - 3] == RemeshStage::placement);
  CHECK(stages[stages.size() - 2] == RemeshStage::search);
  CHECK(stages.back() == RemeshStage::distance);
  for (std::size_t i = 0; i + 3 < stages.size(); ++i) {
    CHECK(stages[i] == (i % 2 == 0 ? RemeshStage::diagram : RemeshStage::dual));
  }
}

TEST_CASE("remesh: every step can be cancelled, those of the map and of the pictures, too") {
  const Mesh mesh = test::make_torus(16, 8);
  const auto generators = test::random_generators(mesh, 4, 1);
  const auto calls = test::require_cancelled_everywhere([&](const Progress& progress) {
    RemeshOptions options;
    options.diagram.threads = 1;
    options.diagram.progress = progress;
    const RemeshResult result = remesh(mesh, generators, options);
    map_to_remesh(mesh, result, 1, progress);
    make_remesh_scenes(mesh, result, make_unplaced(mesh, result), 1, progress);
  });
  for (const char* step : {"dual", "repair", "placement", "self-intersections", "distance", "cut", "map", "view"}) {
    CAPTURE(step);
    CHECK(calls.contains(step));
  }
}

TEST_CASE("remesh: the repair of many loose parts tells of each of them") {
  constexpr int kParts = 40;
  const Mesh mesh = test::make_loose_triangles(kParts);
  const auto calls = test::require_cancelled_everywhere([&](const Progress& progress) {
    RemeshOptions options;
    options.diagram.threads = 1;
    options.diagram.progress = progress;
    remesh(mesh, {vertex_point(mesh, VertexId(0))}, options);
  });
  CHECK(calls.at("repair") >= kParts - 1);
}

}  // namespace gvd::test_remesh
