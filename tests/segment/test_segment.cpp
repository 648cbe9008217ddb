#include <algorithm>
#include <random>

#include "gvd/error.hpp"
#include "gvd/sampling.hpp"
#include "gvd/segment.hpp"
#include "region_topology.hpp"
#include "segment/plain_topology.hpp"
#include "segment/restricted_voronoi.hpp"
#include "support/cancelled.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_segment {

double uniform(std::mt19937& random) { return double(random()) / double(std::mt19937::max()); }

std::vector<SurfacePoint> random_points(const Mesh& mesh, int count, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<SurfacePoint> points;
  for (int i = 0; i < count; ++i) {
    const FaceId face(random() % static_cast<unsigned>(mesh.face_count()));
    const double u = uniform(random), v = uniform(random) * (1 - u);
    points.push_back(make_surface_point(face, {u, v, 1 - u - v}));
  }
  return points;
}

void require_guarantees(const Mesh& mesh, const Diagram& diagram, const Segmentation& result) {
  REQUIRE(result.face_label.size() == static_cast<std::size_t>(mesh.face_count()));
  REQUIRE(std::all_of(result.face_label.begin(), result.face_label.end(), [](GeneratorId g) { return g.valid(); }));
  const auto regions = test::find_topology(mesh, result.face_label);
  for (const auto& [label, region] : regions) {
    CAPTURE(label.value());
    REQUIRE(region.components == 1);
  }
  REQUIRE(regions.size() + result.without_face.size() == diagram.generators.size());
  for (const GeneratorId g : result.without_face) REQUIRE(regions.count(g) == 0);
}

/// A square of two faces, (0,0) (1,0) (1,1) and (0,0) (1,1) (0,1).
Mesh make_square() { return test::make_grid(1, 1); }

TEST_CASE("segments: labels are connected and every generator is accounted for") {
  for (const auto& [name, mesh] : test::small_family()) {
    if (compute_mesh_summary(mesh).components > 1) continue;
    for (const int count : {1, 2, 5, 30, 100}) {
      CAPTURE(name, count);
      const std::vector<SurfacePoint> points = random_points(mesh, count, 3);
      const Diagram straight = test::make_restricted_voronoi(mesh, points), exact = compute_diagram(mesh, points);
      require_guarantees(mesh, straight, segment_faces(mesh, straight));
      require_guarantees(mesh, exact, segment_faces(mesh, exact));
    }
  }
}

TEST_CASE("segments: more generators than faces, so that some own none") {
  const Mesh mesh = test::make_sphere(0);
  const Diagram diagram = test::make_restricted_voronoi(mesh, random_points(mesh, 60, 1));
  const Segmentation result = segment_faces(mesh, diagram);
  require_guarantees(mesh, diagram, result);
  CHECK(result.without_face.size() >= 40);
}

TEST_CASE("segments: an uncut face takes its cell, a cut one the largest share") {
  const Mesh mesh = make_square();
  Diagram diagram;
  diagram.generators = {make_surface_point(FaceId(0), {0, 1, 0}), make_surface_point(FaceId(1), {0, 0, 1})};
  diagram.face_label.assign(2, GeneratorId());
  diagram.face_label[FaceId(1)] = GeneratorId(1);
  diagram.pieces = {{FaceId(0), GeneratorId(0), {{0.4, 0.6, 0}, {0, 1, 0}, {0, 0.6, 0.4}}},
                    {FaceId(0), GeneratorId(1), {{1, 0, 0}, {0.4, 0.6, 0}, {0, 0.6, 0.4}, {0, 0, 1}}}};
  // Generator 0 has 16 % of face 0, which holds it, and generator 1 keeps face 1.
  const Segmentation result = segment_faces(mesh, diagram);
  CHECK(result.face_label[FaceId(0)] == GeneratorId(0));
  CHECK(result.face_label[FaceId(1)] == GeneratorId(1));
  CHECK(result.given_faces == 1);
  CHECK(result.without_face.empty());
}

TEST_CASE("segments: a generator that can't get a face is listed") {
  const Mesh mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{VertexId(0), VertexId(1), VertexId(2)}});
  const std::vector<SurfacePoint> points{vertex_point(mesh, VertexId(0)), vertex_point(mesh, VertexId(1))};
  const Segmentation result = segment_faces(mesh, test::make_restricted_voronoi(mesh, points));
  CHECK(result.face_label[FaceId(0)] == GeneratorId(0));
  CHECK(result.without_face == std::vector<GeneratorId>{GeneratorId(1)});
}

TEST_CASE("segments: a component without a generator has no label") {
  const Mesh mesh = test::make_two_components();
  Diagram diagram;
  diagram.generators = {vertex_point(mesh, VertexId(0))};
  const auto component = compute_face_components(mesh);
  for (const std::int32_t c : component) diagram.face_label.push_back(c == 0 ? GeneratorId(0) : GeneratorId());
  const Segmentation result = segment_faces(mesh, diagram);
  CHECK(result.face_label == diagram.face_label);
  const CutMesh cut = cut_faces(mesh, diagram);
  CHECK(cut.label == diagram.face_label);
  CHECK(cut.mesh.face_count() == mesh.face_count());
}

TEST_CASE("segments: a diagram of another mesh is refused") {
  const Diagram diagram = test::make_restricted_voronoi(make_square(), random_points(make_square(), 2, 1));
  CHECK_THROWS_AS(segment_faces(test::make_sphere(1), diagram), Error);
  CHECK_THROWS_AS(cut_faces(test::make_sphere(1), diagram), Error);
}

TEST_CASE("cut: the surface, its topology and the cells' areas do not change") {
  for (const auto& [name, mesh] : test::small_family()) {
    for (const int count : {1, 2, 30, 200}) {
      CAPTURE(name, count);
      const Diagram diagram = test::make_restricted_voronoi(mesh, random_points(mesh, count, 5));
      const CutMesh cut = cut_faces(mesh, diagram);
      CHECK(cut.uncut_faces == 0);
      const MeshSummary before = compute_mesh_summary(mesh), after = compute_mesh_summary(cut.mesh);
      CHECK(after.euler_characteristic == before.euler_characteristic);
      CHECK(after.boundary_loops == before.boundary_loops);
      CHECK(after.components == before.components);
      CHECK(after.area == Approx(before.area).epsilon(1e-9));
      REQUIRE(cut.parent.size() == static_cast<std::size_t>(cut.mesh.face_count()));
      CHECK(std::is_sorted(cut.parent.begin(), cut.parent.end()));
      std::vector<double> by_parent(static_cast<std::size_t>(mesh.face_count()), 0);
      for (int f = 0; f < cut.mesh.face_count(); ++f)
        by_parent[cut.parent[FaceId(f)].index()] += cut.mesh.area(FaceId(f));
      for (int f = 0; f < mesh.face_count(); ++f) {
        REQUIRE(by_parent[std::size_t(f)] == Approx(mesh.area(FaceId(f))).epsilon(1e-9).margin(1e-12));
      }
    }
  }
}

TEST_CASE("cut: a face that only its neighbour's bisector touches is split at that point") {
  const Mesh mesh = make_square();
  Diagram diagram;
  diagram.generators = {make_surface_point(FaceId(0), {0, 1, 0}), make_surface_point(FaceId(1), {0, 0, 1})};
  diagram.face_label.assign(2, GeneratorId());
  diagram.face_label[FaceId(1)] = GeneratorId(1);
  diagram.pieces = {{FaceId(0), GeneratorId(0), {{0.4, 0.6, 0}, {0, 1, 0}, {0, 0, 1}, {0.5, 0, 0.5}}},
                    {FaceId(0), GeneratorId(1), {{1, 0, 0}, {0.4, 0.6, 0}, {0.5, 0, 0.5}}}};
  const CutMesh cut = cut_faces(mesh, diagram);
  CHECK(cut.uncut_faces == 0);
  CHECK(cut.mesh.vertex_count() == 6);
  CHECK(cut.mesh.face_count() == 5);
  CHECK(compute_mesh_summary(cut.mesh).area == Approx(1));
}

TEST_CASE("cut: pieces that do not tile their face leave it whole") {
  const Mesh mesh = make_square();
  Diagram diagram;
  diagram.generators = {make_surface_point(FaceId(0), {0, 1, 0}), make_surface_point(FaceId(1), {0, 0, 1})};
  diagram.face_label.assign(2, GeneratorId());
  diagram.face_label[FaceId(1)] = GeneratorId(1);
  diagram.pieces = {{FaceId(0), GeneratorId(0), {{0.4, 0.6, 0}, {0, 1, 0}, {0, 0, 1}}}};
  const CutMesh cut = cut_faces(mesh, diagram);
  CHECK(cut.uncut_faces == 1);
  CHECK(compute_mesh_summary(cut.mesh).area == Approx(1));
  CHECK(compute_mesh_summary(cut.mesh).boundary_loops == 1);
}

TEST_CASE("cut: a piece that is not convex and one with collinear corners") {
  const Mesh mesh({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{VertexId(0), VertexId(1), VertexId(2)}});
  Diagram diagram;
  diagram.generators = {vertex_point(mesh, VertexId(0)), vertex_point(mesh, VertexId(1))};
  diagram.face_label.assign(1, GeneratorId());
  const std::array<double, 3> p{0.75, 0.25, 0}, q{0.5, 0.25, 0.25}, r{0.75, 0, 0.25}, half{0.5, 0.5, 0};
  diagram.pieces = {{FaceId(0), GeneratorId(0), {{1, 0, 0}, p, q, r}},
                    {FaceId(0), GeneratorId(1), {p, half, {0, 1, 0}, {0, 0, 1}, r, q}}};
  const CutMesh cut = cut_faces(mesh, diagram);
  CHECK(cut.uncut_faces == 0);
  double area[2]{};
  for (int f = 0; f < cut.mesh.face_count(); ++f) area[cut.label[FaceId(f)].index()] += cut.mesh.area(FaceId(f));
  CHECK(area[0] == Approx(1));
  CHECK(area[1] == Approx(7));
  for (int f = 0; f < cut.mesh.face_count(); ++f) CHECK(cut.mesh.area(FaceId(f)) > 0.1);
}

TEST_CASE("cut: along bisectors with points inside faces") {
  for (const auto& [name, mesh] : test::small_family()) {
    std::int32_t fewest = 0;
    for (const double tolerance : {1e-2, 1e-4, 1e-7}) {
      CAPTURE(name, tolerance);
      DiagramOptions options;
      options.method = Method::exact;
      options.chord_tolerance = tolerance;
      const Diagram diagram = compute_diagram(mesh, random_points(mesh, 12, 8), options);
      const CutMesh cut = cut_faces(mesh, diagram);
      const MeshSummary before = compute_mesh_summary(mesh), after = compute_mesh_summary(cut.mesh);
      CHECK(cut.uncut_faces == 0);
      CHECK(after.euler_characteristic == before.euler_characteristic);
      CHECK(after.boundary_loops == before.boundary_loops);
      IdVector<GeneratorId, double> area(diagram.generators.size(), 0.0);
      for (int f = 0; f < cut.mesh.face_count(); ++f) {
        if (cut.label[FaceId(f)].valid()) area[cut.label[FaceId(f)]] += cut.mesh.area(FaceId(f));
      }
      for (const Cell& cell : diagram.cells) CHECK(area[cell.generator] == Approx(cell.area));
      CHECK(cut.mesh.face_count() >= fewest);  // a finer tolerance has more points
      fewest = cut.mesh.face_count();
    }
    CHECK(fewest > mesh.face_count());
  }
}

TEST_CASE("cut: two coincident faces give a manifold") {
  // Two triangles back to back.
  const std::vector<std::array<VertexId, 3>> closed{{VertexId(0), VertexId(1), VertexId(2)},
                                                    {VertexId(0), VertexId(2), VertexId(1)}};
  const std::vector<Vec3> triangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const Mesh mesh(triangle, closed);
  for (const int count : {2, 3, 5, 20}) {
    for (unsigned seed = 0; seed < 5; ++seed) {
      CAPTURE(count, seed);
      const Diagram diagram = compute_diagram(mesh, random_points(mesh, count, seed));
      const CutMesh cut = cut_faces(mesh, diagram);
      const MeshSummary before = compute_mesh_summary(mesh), after = compute_mesh_summary(cut.mesh);
      CHECK(after.euler_characteristic == before.euler_characteristic);
      CHECK(after.boundary_loops == before.boundary_loops);
      CHECK(after.area == Approx(before.area));
      CHECK(cut.uncut_faces == 0);
      CHECK(std::is_sorted(cut.parent.begin(), cut.parent.end()));
    }
  }
}

TEST_CASE("cut: faces without area, where cuts of different edges coincide") {
  // Two triangles above and below of a line; between them four without area, whose sides slide along it.
  std::vector<Vec3> positions;
  for (const double x : {4, 6, 4, 2, 1, 3, 5, 3}) positions.emplace_back(x, 0, 0);
  positions.front().y() = -2;
  positions.back().y() = 2;
  std::vector<std::array<VertexId, 3>> faces;
  const int corners[8][3] = {{0, 1, 2}, {0, 2, 3}, {3, 2, 4}, {2, 1, 6}, {2, 6, 4}, {4, 6, 5}, {5, 6, 7}, {4, 5, 7}};
  for (const auto& [a, b, c] : corners) faces.push_back({VertexId(a), VertexId(b), VertexId(c)});
  const Mesh mesh(positions, faces);
  for (const Method method : {Method::exact, Method::gbgvd}) {
    for (const int count : {2, 5, 20, 30, 50}) {
      CAPTURE(method.solver == Solver::windows, count);
      DiagramOptions options;
      options.method = method;
      SamplingOptions sampling;
      sampling.count = count;
      const CutMesh cut = cut_faces(mesh, compute_diagram(mesh, sample_generators(mesh, sampling), options));
      const MeshSummary before = compute_mesh_summary(mesh), after = compute_mesh_summary(cut.mesh);
      CHECK(after.euler_characteristic == before.euler_characteristic);
      CHECK(after.boundary_loops == before.boundary_loops);
      CHECK(after.area == Approx(before.area));
      for (int v = 0; v < mesh.vertex_count(); ++v) CHECK(cut.mesh.position(VertexId(v)) == mesh.position(VertexId(v)));
    }
  }
}

TEST_CASE("cut: far from the origin, where points of different edges coincide by rounding") {
  // At 1e10, four units in the last place of a coordinate are about the chord tolerance. Points of one arc then merge,
  // and the pieces of a face may overlap: such a face stays whole, and is counted.
  const std::vector<std::pair<double, std::int64_t>> offsets_and_uncut{{1e8, 0}, {1e10, 1}};
  for (const auto& [name, mesh] : test::small_family()) {
    for (const auto& [offset, uncut] : offsets_and_uncut) {
      std::vector<Vec3> positions = mesh.positions();
      for (Vec3& p : positions) p += Vec3::Constant(offset);
      std::vector<std::array<VertexId, 3>> faces;
      for (int f = 0; f < mesh.face_count(); ++f) faces.push_back(mesh.vertices(FaceId(f)));
      Mesh moved;
      try {
        moved = Mesh(std::move(positions), std::move(faces));
      } catch (const Error&) {
        continue;  // corners have become one
      }
      CAPTURE(name, offset);
      const CutMesh cut = cut_faces(moved, compute_diagram(moved, random_points(moved, 300, 5)));
      const MeshSummary before = compute_mesh_summary(moved), after = compute_mesh_summary(cut.mesh);
      CHECK(cut.uncut_faces <= uncut);
      CHECK(after.euler_characteristic == before.euler_characteristic);
      CHECK(after.boundary_loops == before.boundary_loops);
    }
  }
}

TEST_CASE("cut: only edges inside coincident faces get a vertex at their midpoint") {
  const Mesh mesh({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}},
                  {{VertexId(0), VertexId(1), VertexId(2)}, {VertexId(0), VertexId(2), VertexId(1)}});
  Diagram diagram;
  diagram.generators = {vertex_point(mesh, VertexId(0)), vertex_point(mesh, VertexId(1))};
  diagram.face_label.assign(2, GeneratorId());
  // One cut on each side, from the middle of side 0 1 to corner 2.
  diagram.pieces = {{FaceId(0), GeneratorId(0), {{1, 0, 0}, {0.5, 0.5, 0}, {0, 0, 1}}},
                    {FaceId(0), GeneratorId(1), {{0.5, 0.5, 0}, {0, 1, 0}, {0, 0, 1}}},
                    {FaceId(1), GeneratorId(0), {{1, 0, 0}, {0, 1, 0}, {0.5, 0, 0.5}}},
                    {FaceId(1), GeneratorId(1), {{0.5, 0, 0.5}, {0, 1, 0}, {0, 0, 1}}}};
  const CutMesh cut = cut_faces(mesh, diagram);
  CHECK(cut.mesh.vertex_count() == 6);  // three corners, one point on the side, two middles
  CHECK(cut.mesh.face_count() == 8);
  for (int f = 0; f < 8; ++f) CHECK(cut.parent[FaceId(f)] == FaceId(f / 4));
  double area[2]{};
  for (int f = 0; f < 8; ++f) area[cut.label[FaceId(f)].index()] += cut.mesh.area(FaceId(f));
  CHECK(area[0] == Approx(8));
  CHECK(area[1] == Approx(8));
}

TEST_CASE("segmenting can be cancelled in every step, and tells of each generator that looks for a face") {
  const Mesh mesh = make_square();
  const Diagram diagram = compute_diagram(mesh, random_points(mesh, 40, 1));
  const auto calls = test::require_cancelled_everywhere([&](const Progress& progress) {
    segment_faces(mesh, diagram, {FaceLabels::smooth, progress});
    cut_faces(mesh, diagram, progress);
  });
  CHECK(calls.at("labels") >= 2 * (40 - 2));  // two faces have two labels
  CHECK(calls.contains("borders"));
  CHECK(calls.contains("cut"));
}

}  // namespace gvd::test_segment
