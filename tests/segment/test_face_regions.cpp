// Diagrams inside regions. The oracle is a region that was cut out and stands alone as a mesh of its own.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <random>
#include <set>

#include "gvd/check.hpp"
#include "gvd/face_regions.hpp"
#include "gvd/read_soup.hpp"
#include "gvd/read_values.hpp"
#include "support/catch.hpp"
#include "support/many_threads.hpp"
#include "support/meshes.hpp"
#include "support/refusal.hpp"
#include "support/same_diagram.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_face_regions {

using namespace test;
using Catch::Matchers::Contains;

FaceRegions label_faces(const Mesh& mesh, const std::function<int(FaceId, const Vec3&)>& label) {
  FaceRegions regions;
  for (const FaceId f : mesh.faces()) {
    const auto& [a, b, c] = mesh.vertices(f);
    regions.push_back(label(f, (mesh.position(a) + mesh.position(b) + mesh.position(c)) / 3));
  }
  return regions;
}

/// Three bands along x; the third one has a number below the others.
FaceRegions bands(const Mesh& mesh) {
  double low = mesh.position(VertexId(0)).x(), high = low;
  for (const Vec3& p : mesh.positions()) std::tie(low, high) = std::pair(std::min(low, p.x()), std::max(high, p.x()));
  return label_faces(mesh, [&](FaceId, const Vec3& p) {
    const int band = std::min(2, int(3 * (p.x() - low) / (high - low)));
    return std::array{7, 9, 2}[std::size_t(band)];
  });
}

RegionSamples sample(const SeparatedMesh& mesh, const FaceRegions& regions, int count,
                     Sampling kind = Sampling::farthest) {
  RegionSamplingOptions options;
  options.sampling.kind = kind;
  options.sampling.count = count;
  options.sampling.seed = 5;
  return sample_regions(mesh, regions, options);
}

/// The faces of one region as a mesh, with the vertices in the order of the input, and these faces.
struct CutOut {
  CutOut(const Mesh& from, const FaceRegions& regions, int region) {
    std::map<VertexId, VertexId> number;
    for (const FaceId f : from.faces()) {
      if (regions[f] != region) continue;
      faces.push_back(f);
      for (const VertexId v : from.vertices(f)) number[v];
    }
    std::vector<Vec3> positions;
    for (auto& [v, own] : number) {
      own = VertexId(positions.size());
      positions.push_back(from.position(v));
      vertices.push_back(v);
    }
    std::vector<std::array<VertexId, 3>> corners;
    for (const FaceId f : faces) {
      const auto& [a, b, c] = from.vertices(f);
      corners.push_back({number[a], number[b], number[c]});
    }
    mesh = Mesh(std::move(positions), std::move(corners));
  }

  Mesh mesh;
  std::vector<FaceId> faces;
  std::vector<VertexId> vertices;
};

TEST_CASE("separate regions: one region of all faces is the input") {
  for (const auto& [name, mesh] : small_family()) {
    CAPTURE(name);
    const SeparatedMesh same = separate_regions(mesh, label_faces(mesh, [](FaceId, const Vec3&) { return 4; }));
    CHECK(same.mesh.positions() == mesh.positions());
    CHECK(same.mesh.face_vertices() == mesh.face_vertices());
    CHECK(same.input_vertices == mesh.vertex_count());
  }
}

TEST_CASE("separate regions: each part is a component with the faces' own positions, whatever the labels") {
  for (const auto& [name, mesh] : small_family()) {
    CAPTURE(name);
    const std::vector<FaceRegions> all{bands(mesh), label_faces(mesh, [](FaceId f, const Vec3&) { return f.value(); }),
                                       label_faces(mesh, [](FaceId f, const Vec3&) { return f.value() % 2 - 1; }),
                                       label_faces(mesh, [](FaceId f, const Vec3&) { return f.value() * 7919 % 5; })};
    for (const FaceRegions& regions : all) {
      const SeparatedMesh apart = separate_regions(mesh, regions);
      REQUIRE(apart.mesh.face_count() == mesh.face_count());
      for (const FaceId f : mesh.faces()) {
        for (int i = 0; i < 3; ++i) {
          const VertexId v = apart.mesh.vertices(f)[std::size_t(i)];
          CHECK(apart.input_vertex[v] == mesh.vertices(f)[std::size_t(i)]);
          const HalfedgeId h = Mesh::halfedge(f, i), twin = mesh.twin(h);
          const bool is_border = twin.valid() && std::max(-1, regions[f]) != std::max(-1, regions[Mesh::face(twin)]);
          CHECK(apart.mesh.twin(h) == (is_border ? HalfedgeId() : twin));
        }
      }
      for (const VertexId v : mesh.vertices()) CHECK(apart.input_vertex[v] == v);
    }
  }
}

TEST_CASE("separate regions: a bow-tie comes apart at its vertex, and the least region keeps the vertices") {
  const Mesh mesh = make_grid(2, 2);  // vertex 4 is the centre
  const auto is_diagonal = [](const Vec3& p) { return (p.x() < 1) == (p.y() < 1); };
  const FaceRegions bow = label_faces(mesh, [&](FaceId, const Vec3& p) { return is_diagonal(p) ? 8 : 3; });
  const SeparatedMesh apart = separate_regions(mesh, bow);
  CHECK(compute_mesh_summary(apart.mesh).components == 4);
  CHECK(apart.mesh.vertex_count() == 9 + 3 + 4);  // the centre has three copies, the middles of the sides one each
  for (const FaceId f : mesh.faces()) {
    const auto& corners = apart.mesh.vertices(f);
    const bool keeps_centre = std::ranges::find(corners, VertexId(4)) != corners.end();
    if (keeps_centre) CHECK(bow[f] == 3);
  }
  const RegionSamples three = sample(apart, bow, 3);
  CHECK(three.regions == 2);
  CHECK(three.parts == 4);
  CHECK(three.empty_parts == 1);
  CHECK(sample(apart, bow, 4).empty_parts == 0);

  const FaceRegions left_out = label_faces(mesh, [&](FaceId, const Vec3& p) { return is_diagonal(p) ? -3 : 5; });
  const SeparatedMesh masked = separate_regions(mesh, left_out);
  for (const FaceId f : mesh.faces()) {
    const auto& corners = masked.mesh.vertices(f);
    if (std::ranges::find(corners, VertexId(4)) != corners.end()) CHECK(left_out[f] == 5);
  }
}

TEST_CASE("regions: diagrams, distances and generators inside are those of the region that was cut out") {
  for (const auto& [name, mesh] : small_family()) {
    CAPTURE(name);
    const FaceRegions regions = bands(mesh);
    const SeparatedMesh apart = separate_regions(mesh, regions);
    for (const Sampling kind : {Sampling::farthest, Sampling::random, Sampling::poisson, Sampling::vertices}) {
      const RegionSamples samples = sample(apart, regions, 24, kind);
      REQUIRE(samples.points.size() == 24);
      const Diagram diagram = compute_diagram(apart.mesh, samples.points);
      REQUIRE(check_diagram(apart.mesh, diagram).violations.empty());
      for (const int region : {2, 7, 9}) {
        const CutOut alone(mesh, regions, region);
        std::vector<SurfacePoint> points;
        for (const SurfacePoint& p : samples.points) {
          const auto found = std::ranges::lower_bound(alone.faces, p.face);
          if (found == alone.faces.end() || *found != p.face) continue;
          points.push_back({FaceId(found - alone.faces.begin()), p.bary});
        }
        if (compute_mesh_summary(alone.mesh).components == 1) {
          SamplingOptions options;
          options.kind = kind;
          options.count = std::int32_t(points.size());
          options.seed = 5;
          CHECK(points == sample_generators(alone.mesh, options));
        }
        const Diagram expected = compute_diagram(alone.mesh, points);
        for (std::size_t i = 0; i < alone.faces.size(); ++i) {
          for (int corner = 0; corner < 3; ++corner) {
            const VertexId here = apart.mesh.vertices(alone.faces[i])[std::size_t(corner)];
            const VertexId there = alone.mesh.vertices(FaceId(i))[std::size_t(corner)];
            CHECK(diagram.vertex_distance[here] == Approx(expected.vertex_distance[there]).epsilon(1e-12));
          }
        }
      }
    }
  }
}

TEST_CASE("regions: no label crosses a border, whole faces or cut, and cuts leave no cracks") {
  for (const auto& [name, mesh] : small_family()) {
    CAPTURE(name);
    const std::vector<FaceRegions> all{bands(mesh), label_faces(mesh, [](FaceId f, const Vec3& p) {
                                         return f.value() % 3 == 0 ? -1 : int(p.x() > 0);
                                       })};
    for (const FaceRegions& regions : all) {
      const SeparatedMesh apart = separate_regions(mesh, regions);
      const RegionSamples samples = sample(apart, regions, 40);
      const Diagram diagram = compute_diagram(apart.mesh, samples.points);
      REQUIRE(check_diagram(apart.mesh, diagram).violations.empty());
      const auto region_of = [&](GeneratorId g) { return regions[diagram.generators[g.index()].face]; };
      const Segmentation whole = segment_faces(apart.mesh, diagram);
      for (const FaceId f : mesh.faces()) {
        if (whole.face_label[f].valid()) CHECK(region_of(whole.face_label[f]) == regions[f]);
        if (regions[f] < 0) CHECK_FALSE(whole.face_label[f].valid());
        if (regions[f] >= 0 && samples.empty_parts == 0) CHECK(whole.face_label[f].valid());
      }
      const CutMesh cut = cut_faces(mesh, diagram);
      CHECK(cut.uncut_faces == 0);
      std::map<int, double> area;
      for (const FaceId f : cut.mesh.faces()) {
        const int region = regions[cut.parent[f]];
        area[region] += cut.mesh.area(f);
        if (cut.label[f].valid()) CHECK(region_of(cut.label[f]) == region);
        if (region < 0) CHECK_FALSE(cut.label[f].valid());
      }
      for (const FaceId f : mesh.faces()) area[regions[f]] -= mesh.area(f);
      for (const auto& [region, difference] : area) CHECK(std::abs(difference) < 1e-9 * compute_area(mesh));
      const MeshSummary before = compute_mesh_summary(mesh), after = compute_mesh_summary(cut.mesh);
      CHECK(after.euler_characteristic == before.euler_characteristic);
      CHECK(after.boundary_loops == before.boundary_loops);
      CHECK(after.components == before.components);
    }
  }
}

TEST_CASE("regions: vertices of a cut mesh have distances inside the region of their label") {
  const Mesh mesh = make_grid(6, 6);
  const FaceRegions regions = label_faces(mesh, [](FaceId, const Vec3& p) { return p.x() < 3 ? 1 : 0; });
  const SeparatedMesh apart = separate_regions(mesh, regions);
  const std::vector<SurfacePoint> points{make_surface_point(FaceId(10), {0.3, 0.3, 0.4}),
                                         make_surface_point(FaceId(3), {0.3, 0.3, 0.4}),
                                         make_surface_point(FaceId(60), {0.3, 0.3, 0.4})};
  const Diagram diagram = compute_diagram(apart.mesh, points);
  const CutMesh cut = cut_faces(mesh, diagram);
  const CutVertices carried = carry_to_cut_vertices(apart.mesh, diagram, cut);
  const Diagram on_input = restrict_to_input(apart, diagram);
  REQUIRE(on_input.vertex_label.count() == mesh.vertex_count());
  bool crosses = false;
  for (const VertexId v : cut.mesh.vertices()) {
    if (v.value() < mesh.vertex_count()) CHECK(carried.distance[v] == on_input.vertex_distance[v]);
    const Vec3 at = cut.mesh.position(v), from = position(mesh, points[carried.label[v].index()]);
    // Both halves are flat and convex: distances are straight, and linear interpolation is off by less than an edge.
    CHECK(std::abs(carried.distance[v] - (at - from).norm()) < 0.75);
    if (v.value() >= mesh.vertex_count() && std::abs(at.x() - 3) < 1e-9) {
      crosses =
          true;  // far from the generators interpolation is better: the other side's distances would be off by 0.7
      CHECK(std::abs(carried.distance[v] - (at - from).norm()) < 0.05);
    }
    if (at.x() == 3 && v.value() < mesh.vertex_count()) CHECK(from.x() > 3);
  }
  CHECK(crosses);
}

TEST_CASE("regions: results do not depend on threads, nor on what other regions are") {
  const Mesh mesh = make_bumpy_sphere(3, 7);
  const FaceRegions regions = bands(mesh);
  const SeparatedMesh apart = separate_regions(mesh, regions);
  const std::vector<SurfacePoint> points = sample(apart, regions, 30).points;
  with_many_threads([&] {
    DiagramOptions options;
    options.threads = 1;
    const Diagram first = compute_diagram(apart.mesh, points, options);
    for (const int threads : kThreads) {
      options.threads = threads;
      CHECK(same_diagram(first, compute_diagram(apart.mesh, points, options)));
    }
  });
  FaceRegions others = regions;
  for (std::int32_t& region : others.raw()) region = region == 7 ? 7 : -1;
  const auto in_seven = std::ranges::count_if(points, [&](const SurfacePoint& p) { return regions[p.face] == 7; });
  const RegionSamples alone = sample(separate_regions(mesh, others), others, int(in_seven));
  std::vector<SurfacePoint> seven;
  std::ranges::copy_if(points, std::back_inserter(seven), [&](const SurfacePoint& p) { return regions[p.face] == 7; });
  CHECK(alone.points == seven);
}

TEST_CASE("regions: a single face takes generators of its own, also without area") {
  const Mesh mesh =
      make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 2, 0}, {3, 3, 0}}, {{0, 1, 2}, {2, 1, 3}, {1, 4, 3}});
  const FaceRegions regions(std::vector<std::int32_t>{1, 0, 2});
  const SeparatedMesh apart = separate_regions(mesh, regions);
  for (const Sampling kind : {Sampling::farthest, Sampling::random, Sampling::poisson}) {
    const RegionSamples samples = sample(apart, regions, 9, kind);
    CHECK(samples.points.size() == 9);
    const Diagram diagram = compute_diagram(apart.mesh, samples.points);
    CHECK(check_diagram(apart.mesh, diagram).violations.empty());
    CHECK(cut_faces(mesh, diagram).uncut_faces == 0);
  }
  const Mesh needle = make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.5, 0, 0}}, {{0, 1, 2}, {1, 0, 3}});
  const FaceRegions flat(std::vector<std::int32_t>{0, 1});
  CHECK(sample(separate_regions(needle, flat), flat, 2, Sampling::random).points.size() == 2);
}

TEST_CASE("regions: generators are shared out by area, and each region and part has one") {
  CHECK(share_out(10, {6, 3, 1}, {1, 1, 1}) == std::vector<std::int64_t>{6, 3, 1});
  CHECK(share_out(7, {1, 1, 1}, {1, 1, 1}) == std::vector<std::int64_t>{3, 2, 2});
  CHECK(share_out(5, {1000, 1, 1}, {1, 1, 1}) == std::vector<std::int64_t>{3, 1, 1});
  CHECK(share_out(10, {90, 5, 5}, {1, 4, 1}) == std::vector<std::int64_t>{5, 4, 1});
  CHECK(share_out(3, {0, 0}, {1, 1}) == std::vector<std::int64_t>{2, 1});
  CHECK(share_out(100, {0.3, 0.3, 0.4}, {0, 0, 0}) == std::vector<std::int64_t>{30, 30, 40});

  const Mesh mesh = make_grid(10, 4);
  const FaceRegions regions = label_faces(mesh, [](FaceId, const Vec3& p) {
    return p.x() < 7 ? 0 : p.x() < 9 ? 1 : 2;
  });
  const SeparatedMesh apart = separate_regions(mesh, regions);
  const auto counts = [&](const RegionSamples& samples) {
    std::map<int, int> found;
    for (const SurfacePoint& p : samples.points) ++found[regions[p.face]];
    return found;
  };
  CHECK(counts(sample(apart, regions, 20)) == std::map<int, int>{{0, 14}, {1, 4}, {2, 2}});
  RegionSamplingOptions each;
  each.sampling.count = 3;
  each.each_region = true;
  CHECK(counts(sample_regions(apart, regions, each)) == std::map<int, int>{{0, 3}, {1, 3}, {2, 3}});
  each.each_region = false;
  each.sampling.kind = Sampling::covering_radius;
  each.sampling.radius = 1.5;
  const Diagram covered = compute_diagram(apart.mesh, sample_regions(apart, regions, each).points);
  for (const double distance : covered.vertex_distance) CHECK(distance <= 1.5);
  CHECK_THAT(refusal([&] { sample(apart, regions, 2); }, ErrorCode::precondition),
             Contains("2 generators for 3 regions; ask for one or more in each"));
}

TEST_CASE("regions: faces take the number of most of their vertices, and of three different ones none alone") {
  const Mesh mesh = make_grid(2, 1);  // faces 0 1 4, 0 4 3, 1 2 5, 1 5 4
  const auto regions_of = [&](std::vector<double> values) {
    return make_face_regions(mesh, {true, std::move(values)}).raw();
  };
  // Corners 5 5 7, 5 7 2, 5 1 1 and 5 1 7: the second would be the only face of 2, the last one has a neighbour of 1.
  CHECK(regions_of({5, 5, 1, 2, 7, 1}) == std::vector<std::int32_t>{5, 5, 1, 1});
  CHECK(regions_of({5, 5, 5, 7, 7, 5}) == std::vector<std::int32_t>{5, 7, 5, 5});
  CHECK(make_face_regions(mesh, {false, {-4, 0, 3, 16777215}}).raw() == std::vector<std::int32_t>{-4, 0, 3, 16777215});
  CHECK_THAT(refusal(
                 [&] {
                   regions_of({1, 2, 3});
                 },
                 ErrorCode::precondition),
             Contains("3 numbers; give one for each vertex (6)"));
  CHECK_THAT(refusal(
                 [&] {
                   make_face_regions(mesh, {false, {0, 0.5, 0, 0}});
                 },
                 ErrorCode::precondition),
             Contains("the region of face 1 is 0.5; give whole numbers"));
  CHECK_THAT(refusal(
                 [&] {
                   make_face_regions(mesh, {false, {0, std::nan(""), 0, 0}});
                 },
                 ErrorCode::precondition),
             Contains("face 1 has no number"));
  FaceRegions masked(std::vector<std::int32_t>{1, 1, 2, 2});
  mask_regions(mesh, {false, {0, 0.5, -1, 0}}, masked);
  CHECK(masked.raw() == std::vector<std::int32_t>{1, -1, -1, 2});
  // The last face lost its neighbour to the mask, and has one corner in it.
  FaceRegions beside(std::vector<std::int32_t>{1, 1, 2, 2});
  mask_regions(mesh, {true, {0, 0, 1, 0, 0, 1}}, beside);
  CHECK(beside.raw() == std::vector<std::int32_t>{1, 1, -1, 1});
  CHECK_THAT(refusal(
                 [&] {
                   mask_regions(mesh, {true, {1, 1, 1, 1, 1, 1}}, masked);
                 },
                 ErrorCode::precondition),
             Contains("no face is left"));
}

TEST_CASE("regions: files have numbers of vertices or polygons, and of a property of both that of the faces counts") {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("gvd_regions_" + std::to_string(std::random_device()()));
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "a.ply") << "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
                                     "property float z\nproperty int atlas\nproperty int own\nelement face 2\n"
                                     "property list uchar int vertex_indices\nproperty int atlas\nend_header\n"
                                     "0 0 0 1 4\n1 0 0 1 5\n1 1 0 1 6\n0 1 0 1 7\n2 0 0 1 8\n"
                                     "4 0 1 2 3 6\n3 1 4 2 7\n";
  std::ofstream(folder / "list.txt") << "10, 20 # two polygons\n";
  CheckedMesh input = build_mesh(read_soup(folder / "a.ply"));
  const auto read = [&](const std::string& name) -> std::optional<SoupProperty> {
    const auto given = read_element_values(input, name, folder / "a.ply", SoupElement::polygon, ValueColumns::last);
    return given ? std::optional(to_region_numbers(input, *given)) : std::nullopt;
  };
  CHECK(read("atlas")->values == std::vector<double>{6, 6, 7});
  CHECK_FALSE(read("atlas")->of_vertices);
  CHECK(read((folder / "list.txt").string())->values == std::vector<double>{10, 10, 20});
  CHECK(read("own")->values == std::vector<double>{4, 5, 6, 7, 8});
  CHECK_FALSE(read("other"));
  input.input_vertex[VertexId(4)] = -1;  // as the midpoint of a split edge between vertices 1 and 2
  CHECK(read("own")->values == std::vector<double>{4, 5, 6, 7, 5});
  std::filesystem::remove_all(folder);
}

TEST_CASE("regions: points on borders move into the least region there, and none may be left out") {
  const Mesh mesh = make_grid(2, 2);
  FaceRegions regions = label_faces(mesh, [](FaceId, const Vec3& p) { return p.x() < 1 ? 6 : p.y() < 1 ? 4 : -1; });
  std::vector<SurfacePoint> points{vertex_point(mesh, VertexId(4)), vertex_point(mesh, VertexId(7)),
                                   vertex_point(mesh, VertexId(0))};
  move_into_regions(mesh, regions, points);
  CHECK(regions[points[0].face] == 4);
  CHECK(regions[points[1].face] == 6);
  CHECK(regions[points[2].face] == 6);
  for (const int i : {0, 1, 2})
    CHECK(position(mesh, points[std::size_t(i)]) == mesh.position(VertexId(std::array{4, 7, 0}[std::size_t(i)])));
  points.push_back(vertex_point(mesh, VertexId(8)));
  CHECK_THAT(refusal([&] { move_into_regions(mesh, regions, points); }, ErrorCode::precondition),
             Contains("generator 3 lies on a face that is left out"));
}

TEST_CASE("levels: each region lies in one of the level before") {
  for (const auto& [name, mesh] : small_family()) {
    CAPTURE(name);
    FaceRegions regions;
    const std::int32_t components = compute_mesh_summary(mesh).components;
    for (const int count : {4, 12, 40}) {
      LevelOptions options;
      options.generators.sampling.count = count;
      const FaceRegions finer = to_regions(label_level(mesh, regions, options));
      std::map<int, std::set<int>> within;
      for (const FaceId f : mesh.faces()) {
        CHECK(finer[f] >= 0);
        within[finer[f]].insert(regions.empty() ? 0 : regions[f]);
      }
      CHECK(std::ssize(within) <= count);
      CHECK(std::ssize(within) >= components);
      for (const auto& [label, parents] : within) CHECK(parents.size() == 1);
      regions = finer;
    }
  }
}

}  // namespace gvd::test_face_regions
