// The properties that gvd/sampling.hpp numbers, over the mesh families.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>
#include <set>

#include "geodesic/local_march.hpp"
#include "geodesic/nearest_field.hpp"
#include "gvd/error.hpp"
#include "gvd/generator_list.hpp"
#include "gvd/sampling.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

using namespace gvd;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<SurfacePoint> sample(const Mesh& mesh, Sampling kind, std::int32_t count, std::uint64_t seed = 0) {
  SamplingOptions options;
  options.kind = kind;
  options.count = count;
  options.seed = seed;
  return sample_generators(mesh, options);
}

std::vector<SurfacePoint> cover(const Mesh& mesh, double radius) {
  SamplingOptions options;
  options.kind = Sampling::covering_radius;
  options.radius = radius;
  return sample_generators(mesh, options);
}

ErrorCode error_of(const Mesh& mesh, const SamplingOptions& options) {
  try {
    sample_generators(mesh, options);
  } catch (const Error& error) {
    return error.code();
  }
  FAIL("no error");
  return ErrorCode::interrupted;
}

bool all_distinct(const Mesh& mesh, const std::vector<SurfacePoint>& points) {
  const auto first = find_coincident(mesh, points);
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i] != static_cast<std::int32_t>(i)) return false;
  }
  return true;
}

/// Distances along edges, and straight in the faces of the generators: real paths, so never below the geodesic
/// distance.
std::vector<double> edge_distances(const Mesh& mesh, const std::vector<SurfacePoint>& generators) {
  using Item = std::pair<double, int>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  std::vector<double> distance(static_cast<std::size_t>(mesh.vertex_count()), kInfinity);
  const auto reach = [&](VertexId v, double d) {
    if (!(d < distance[v.index()])) return;
    distance[v.index()] = d;
    queue.push({d, v.value()});
  };
  for (const SurfacePoint& g : generators) {
    for (const VertexId v : mesh.vertices(g.face)) reach(v, (mesh.position(v) - position(mesh, g)).norm());
  }
  std::vector<std::vector<HalfedgeId>> leaving(distance.size());
  for (int h = 0; h < mesh.halfedge_count(); ++h) leaving[mesh.from(HalfedgeId(h)).index()].emplace_back(h);
  while (!queue.empty()) {
    const auto [d, v] = queue.top();
    queue.pop();
    if (d > distance[static_cast<std::size_t>(v)]) continue;
    for (const HalfedgeId h : leaving[static_cast<std::size_t>(v)]) {
      reach(mesh.to(h), d + mesh.length(h));
      reach(mesh.opposite(h), d + mesh.length(Mesh::previous(h)));
    }
  }
  return distance;
}

/// Least distance between two of the points, by one march each.
double least_spacing(const Mesh& mesh, const std::vector<SurfacePoint>& points) {
  LocalMarch march(mesh, Front::circle);
  double least = kInfinity;
  for (std::size_t i = 0; i < points.size(); ++i) {
    march.run(points[i], kInfinity);
    for (std::size_t k = i + 1; k < points.size(); ++k) least = std::min(least, march.distance(points[k]));
  }
  return least;
}

Mesh make_three_spheres() {
  const Mesh sphere = test::make_sphere(1);
  std::vector<Vec3> positions;
  std::vector<std::array<VertexId, 3>> faces;
  for (int copy = 0; copy < 3; ++copy) {
    for (const Vec3& p : sphere.positions()) positions.push_back(p / (1 + copy) + Vec3(3 * copy, 0, 0));
    for (int f = 0; f < sphere.face_count(); ++f) {
      auto face = sphere.vertices(FaceId(f));
      for (VertexId& v : face) v = VertexId(v.value() + copy * sphere.vertex_count());
      faces.push_back(face);
    }
  }
  return Mesh(std::move(positions), std::move(faces));
}

const std::vector<Sampling> kCounted{Sampling::farthest, Sampling::random, Sampling::poisson};

}  // namespace

TEST_CASE("property 1: exactly N different generators, also more than there are vertices and faces") {
  for (const auto& [name, mesh] : test::small_family()) {
    for (const Sampling kind : kCounted) {
      for (const int count : {1, 2, 100, mesh.vertex_count(), mesh.vertex_count() + 10, 2 * mesh.face_count()}) {
        INFO(name << ", kind " << int(kind) << ", " << count);
        const auto points = sample(mesh, kind, count);
        REQUIRE(points.size() == static_cast<std::size_t>(count));
        REQUIRE(all_distinct(mesh, points));
        for (const SurfacePoint& p : points) {
          REQUIRE((p.face.valid() && p.face.value() < mesh.face_count()));
          REQUIRE(make_surface_point(p.face, p.bary).kind() == p.kind());
        }
      }
    }
  }
}

TEST_CASE("one triangle takes any number of generators") {
  const Mesh triangle({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{VertexId(0), VertexId(1), VertexId(2)}});
  for (const Sampling kind : kCounted) {
    for (const int count : {1, 2, 3, 4, 50, 1000}) {
      const auto points = sample(triangle, kind, count);
      REQUIRE(points.size() == static_cast<std::size_t>(count));
      REQUIRE(all_distinct(triangle, points));
    }
  }
}

TEST_CASE("property 2: the seed decides, and nothing else does") {
  for (const auto& [name, mesh] : test::small_family()) {
    for (const Sampling kind : kCounted) {
      INFO(name << ", kind " << int(kind));
      CHECK(sample(mesh, kind, 20, 5) == sample(mesh, kind, 20, 5));
      CHECK(sample(mesh, kind, 20, 5) != sample(mesh, kind, 20, 6));
    }
  }
}

TEST_CASE("random numbers are those that the standard fixes") {
  // The 10000th output of a default-constructed std::mt19937_64 is in the standard; this is the engine's own seed.
  std::mt19937_64 engine;
  engine.discard(9999);
  CHECK(engine() == 9981545732273789042ULL);
  const Mesh square = test::make_grid(1, 1);
  const auto points = sample(square, Sampling::random, 1, 7);
  std::mt19937_64 same(7);
  const auto real = [&] { return double(same() >> 11) / 9007199254740992.0; };
  const double face = real(), root = std::sqrt(real()), along = real();
  CHECK(points[0].face == FaceId(face < 0.5 ? 0 : 1));
  CHECK(points[0].bary[1] == Approx(root * (1 - along)));
}

TEST_CASE("random points are uniform by area") {
  const Mesh grid = test::make_grid(4, 1);
  std::array<int, 4> columns{};
  const auto points = sample(grid, Sampling::random, 20000, 3);
  Vec3 mean = Vec3::Zero();
  for (const SurfacePoint& p : points) {
    const Vec3 x = position(grid, p);
    ++columns[static_cast<std::size_t>(x.x())];
    mean += x / 20000;
    REQUIRE(p.kind() == SurfacePoint::Kind::face);
  }
  // Six standard deviations: sqrt(20000 / 4 * 3 / 4) = 61 points; 1 / sqrt(12 * 20000) = 0.002 for the height.
  for (const int column : columns) CHECK(std::abs(column - 5000) < 370);
  CHECK(std::abs(mean.y() - 0.5) < 0.0125);
}

TEST_CASE("property 3: every component gets a point, in order, and none more than once before") {
  const Mesh mesh = make_three_spheres();
  const auto component = compute_face_components(mesh);
  for (const int count : {1, 2, 3, 10}) {
    const auto points = sample(mesh, Sampling::farthest, count, 4);
    for (int i = 0; i < std::min(count, 3); ++i) CHECK(component[points[static_cast<std::size_t>(i)].face] == i);
  }
  std::set<int> covered;
  for (const SurfacePoint& p : cover(mesh, 10)) covered.insert(component[p.face]);
  CHECK(covered.size() == 3);
}

TEST_CASE("property 3: each point is the farthest from all before it, so the radii never rise") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const auto points = sample(mesh, Sampling::farthest, 60, 1);
    const auto components = static_cast<std::size_t>(compute_mesh_summary(mesh).components);
    NearestField field(mesh, Front::circle);
    double before = kInfinity;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (i >= components) {
        double farthest = 0;
        for (int v = 0; v < mesh.vertex_count(); ++v) farthest = std::max(farthest, field.distance(VertexId(v)));
        const double here = field.distance(vertex(mesh, points[i]));
        CHECK(here == farthest);
        CHECK(here <= before);
        before = here;
      }
      field.insert(points[i]);
    }
  }
}

TEST_CASE("inserting one by one gives the distances of each generator alone") {
  for (const auto& [name, mesh] : test::small_family()) {
    const auto points = sample(mesh, Sampling::random, 30, 2);
    NearestField field(mesh, Front::circle);
    LocalMarch march(mesh, Front::circle);
    std::vector<double> nearest(static_cast<std::size_t>(mesh.vertex_count()), kInfinity);
    for (const SurfacePoint& p : points) {
      field.insert(p);
      march.run(p, kInfinity);
      for (int v = 0; v < mesh.vertex_count(); ++v) {
        nearest[static_cast<std::size_t>(v)] =
            std::min(nearest[static_cast<std::size_t>(v)], march.distance(VertexId(v)));
      }
    }
    for (int v = 0; v < mesh.vertex_count(); ++v) {
      INFO(name << ", vertex " << v);
      // Never nearer than alone; a front that stops one ring beyond its cell may lose a little near the border, and
      // among slivers, where a straight path passes by vertices of other cells, up to a quarter.
      const double loss = name == "sliver sphere" ? 0.25 : 0.05;
      const double whole = nearest[static_cast<std::size_t>(v)], inserted = field.distance(VertexId(v));
      CHECK(inserted >= whole * (1 - 1e-12));
      CHECK(inserted <= whole * (1 + loss) + 0.05 * mesh.mean_edge_length());
    }
  }
}

TEST_CASE("a march on a flat mesh measures straight lines") {
  const Mesh grid = test::make_grid(9, 7);
  LocalMarch march(grid, Front::circle);
  const auto starts = sample(grid, Sampling::random, 20, 1), ends = sample(grid, Sampling::random, 50, 2);
  const SurfacePoint on_edge = edge_point(HalfedgeId(31), 0.3), on_vertex = vertex_point(grid, VertexId(25));
  std::vector<SurfacePoint> all = starts;
  all.insert(all.end(), {on_edge, on_vertex});
  for (const SurfacePoint& start : all) {
    march.run(start, kInfinity);
    for (const SurfacePoint& end : ends) {
      const double straight = (position(grid, start) - position(grid, end)).norm();
      CHECK(march.distance(end) == Approx(straight).epsilon(0.01));
    }
  }
}

TEST_CASE("property 4: a covering on the plane, by brute force") {
  for (const double radius : {0.4, 1.3, 3.0, 20.0}) {
    const Mesh grid = test::make_grid(8, 6);
    const auto generators = cover(grid, radius);
    double farthest = 0;
    for (double x = 0; x <= 8; x += 0.05) {
      for (double y = 0; y <= 6; y += 0.05) {
        double nearest = kInfinity;
        for (const SurfacePoint& g : generators)
          nearest = std::min(nearest, (position(grid, g) - Vec3(x, y, 0)).norm());
        farthest = std::max(farthest, nearest);
      }
    }
    INFO(radius << ": " << generators.size());
    CHECK(farthest <= radius * 1.001);
    // Farthest points are a packing as well: half the radius' discs hardly overlap.
    CHECK(static_cast<double>(generators.size()) <= (8 + radius) * (6 + radius) / (0.5 * radius * radius) + 1);
  }
}

TEST_CASE("property 4: a covering on the sphere, by its great circles") {
  const Mesh sphere = test::make_sphere(4);
  for (const double radius : {0.15, 0.5, 1.2, 4.0}) {
    const auto generators = cover(sphere, radius);
    double farthest = 0;
    for (int v = 0; v < sphere.vertex_count(); ++v) {
      double nearest = kInfinity;
      for (const SurfacePoint& g : generators) {
        const Vec3 p = position(sphere, g).normalized();
        nearest = std::min(
            nearest, std::atan2(p.cross(sphere.position(VertexId(v))).norm(), p.dot(sphere.position(VertexId(v)))));
      }
      farthest = std::max(farthest, nearest);
    }
    CHECK(farthest <= radius * 1.01);
    CHECK(generators.size() <= 1 + static_cast<std::size_t>(16 / (radius * radius)));
  }
  CHECK(cover(sphere, 4).size() == 1);
}

TEST_CASE("property 4: on every family no vertex is far by an independent upper bound") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const double radius = 0.2 * mesh.bbox_diagonal();
    const auto generators = cover(mesh, radius);
    const auto distance = edge_distances(mesh, generators);
    // Edges of a mesh are a detour of up to sqrt 2 on squares with diagonals in one direction, and more among slivers.
    const double detour = name == "sliver sphere" ? 2.0 : std::numbers::sqrt2;
    CHECK(*std::max_element(distance.begin(), distance.end()) <= detour * radius + 2 * mesh.mean_edge_length());
    CHECK(all_distinct(mesh, generators));
  }
}

TEST_CASE("a covering splits large faces") {
  const Mesh square = test::make_grid(1, 1);
  const auto generators = cover(square, 0.1);
  CHECK(generators.size() > 40);  // each disc covers at most 0.01 pi of the unit square
  CHECK(generators.size() < 150);
  CHECK(all_distinct(square, generators));
}

TEST_CASE("farthest points fill large faces before they crowd on small ones") {
  // A long box: all vertices lie on its two ends.
  Mesh box = test::make_plate(1, 1);
  std::vector<Vec3> positions = box.positions();
  for (Vec3& p : positions) p.z() *= 20;
  std::vector<std::array<VertexId, 3>> faces;
  for (int f = 0; f < box.face_count(); ++f) faces.push_back(box.vertices(FaceId(f)));
  box = Mesh(std::move(positions), std::move(faces));
  const auto points = sample(box, Sampling::farthest, 8);
  int inside = 0;
  for (const SurfacePoint& p : points) inside += position(box, p).z() > 2 && position(box, p).z() < 18;
  CHECK(inside >= 4);
}

TEST_CASE("distances are geodesic: a thin plate's two sides are far apart") {
  const int n = 20;
  const Mesh plate = test::make_plate(n);
  const auto is_top = [&](const SurfacePoint& p) { return position(plate, p).z() > 0.005; };
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const auto points = sample(plate, Sampling::farthest, 2, seed);
    const Vec3 p = position(plate, points[0]), q = position(plate, points[1]);
    // Every start has a point of the plate that far: over the rim to the other side, or across to the far corner.
    const auto distance = edge_distances(plate, {points[0]});
    const double far = distance[vertex(plate, points[1]).index()];
    CHECK(far >= 0.9 * *std::max_element(distance.begin(), distance.end()) / std::numbers::sqrt2);
    const double rim = std::min({p.x(), p.y(), 1 - p.x(), 1 - p.y()});
    if (rim > 0.4) CHECK(is_top(points[0]) != is_top(points[1]));
    if (rim > 0.4) CHECK((p - q).norm() < 0.6 * far);
  }
  // Poisson points keep their spacing on each side, and know nothing of the other side, which is much nearer than that.
  const auto points = sample(plate, Sampling::poisson, 100, 1);
  int near_in_space = 0;
  for (const SurfacePoint& p : points) {
    for (const SurfacePoint& q : points) {
      near_in_space += is_top(p) && !is_top(q) && (position(plate, p) - position(plate, q)).norm() < 0.06;
    }
  }
  CHECK(near_in_space > 5);
  CHECK(least_spacing(plate, points) > 0.08);
}

TEST_CASE("poisson points keep apart as random ones do not") {
  struct Case {
    std::string name;
    Mesh mesh;
  };
  for (const auto& [name, mesh] : std::vector<Case>{{"sphere", test::make_sphere(3)},
                                                    {"plate", test::make_plate(20)},
                                                    {"torus", test::make_torus(48, 20)},
                                                    {"one square", test::make_grid(1, 1)}}) {
    const double area = compute_mesh_summary(mesh).area;
    for (const int count : {50, 300}) {
      for (std::uint64_t seed = 0; seed < 3; ++seed) {
        INFO(name << ", " << count << ", seed " << seed);
        // The spacing of the densest packing in the plane; elimination reaches some 0.7 of it, random points some 0.7
        // divided by the square root of their number.
        const double densest = std::sqrt(2 * area / (std::numbers::sqrt3 * count));
        CHECK(least_spacing(mesh, sample(mesh, Sampling::poisson, count, seed)) > 0.6 * densest);
        CHECK(least_spacing(mesh, sample(mesh, Sampling::random, count, seed)) < 0.25 * densest);
      }
    }
  }
}

TEST_CASE("more points than a mesh has room for, or a bad option, is an error that says so") {
  const Mesh sphere = test::make_sphere(1);
  SamplingOptions options;
  options.count = 0;
  CHECK(error_of(sphere, options) == ErrorCode::invalid_option);
  options.kind = Sampling::covering_radius;
  for (const double radius : {0.0, -1.0, kInfinity, std::nan("")}) {
    options.radius = radius;
    CHECK(error_of(sphere, options) == ErrorCode::invalid_option);
  }
  options.radius = 1e-9;
  CHECK(error_of(sphere, options) == ErrorCode::precondition);
  options.kind = Sampling::farthest;
  options.count = 2'000'000'000;
  CHECK(error_of(sphere, options) == ErrorCode::precondition);
  options.kind = Sampling::poisson;
  CHECK(error_of(sphere, options) == ErrorCode::precondition);
  options.kind = Sampling::random;
  CHECK(error_of(sphere, options) == ErrorCode::precondition);
  options.count = 1;
  options.progress = [](std::string_view, double) { return false; };
  CHECK(error_of(sphere, options) == ErrorCode::interrupted);
}

TEST_CASE("a covering that would split the surface too often is refused before it is split") {
  // No edge alone takes many splits: it is the area that does. The progress callback is reached by splitting only.
  const Mesh square = test::make_grid(1, 1);
  SamplingOptions options;
  options.kind = Sampling::covering_radius;
  int calls = 0;
  options.progress = [&](std::string_view, double) { return ++calls < 2; };
  for (const double radius : {1e-4, 1e-6, 1e-9, 1e-200}) {
    options.radius = radius;
    calls = 0;
    CHECK(error_of(square, options) == ErrorCode::precondition);
    CHECK(calls == 1);
  }
}

TEST_CASE("a face without area: farthest points work, random ones say why not") {
  const Mesh flat({{0, 0, 0}, {2, 0, 0}, {1, 0, 0}}, {{VertexId(0), VertexId(1), VertexId(2)}});
  for (const int count : {1, 3, 20}) {
    const auto points = sample(flat, Sampling::farthest, count);
    CHECK(points.size() == static_cast<std::size_t>(count));
    CHECK(all_distinct(flat, points));
  }
  for (const Sampling kind : {Sampling::random, Sampling::poisson}) {
    SamplingOptions options;
    options.kind = kind;
    CHECK(error_of(flat, options) == ErrorCode::precondition);
  }
}

TEST_CASE("faces without area, folded on each other, do not keep a march from its end") {
  // After a mesh of the field whose points 1, 3 to 6 lie on a line, in faces that overlap there.
  std::vector<std::array<VertexId, 3>> faces;
  for (const auto& [a, b, c] : std::vector<std::array<int, 3>>{
           {0, 1, 2}, {0, 2, 3}, {3, 2, 4}, {2, 1, 6}, {2, 6, 4}, {4, 6, 5}, {5, 6, 7}, {4, 5, 7}}) {
    faces.push_back({VertexId(a), VertexId(b), VertexId(c)});
  }
  const Mesh mesh({{4, -2, 0}, {6, 0, 0}, {4, 0, 0}, {2, 0, 0}, {1, 0, 0}, {3, 0, 0}, {5, 0, 0}, {3, 2, 0}}, faces);
  for (const Sampling kind : kCounted) {
    for (const int count : {1, 8, 18, 300}) {
      const auto points = sample(mesh, kind, count);
      CHECK(points.size() == static_cast<std::size_t>(count));
      CHECK(all_distinct(mesh, points));
    }
  }
  CHECK(!cover(mesh, 0.5).empty());
}

TEST_CASE("a disc made of a fan of needles does not keep a march from its end") {
  // The needles of a polygon's first corner, each cut into rows of equal triangles: row l has l pieces a needle.
  constexpr int kNeedles = 126, kRows = 16;
  std::vector<Vec3> points;
  std::vector<int> row_start;
  for (int row = 0; row <= kRows; ++row) {
    row_start.push_back(static_cast<int>(points.size()));
    for (int k = 0; k <= kNeedles * row; ++k) {
      const int needle = row > 0 ? std::min(k / row, kNeedles - 1) : 0;
      const auto corner = [](int i) -> Vec3 {
        const double angle = 2 * std::numbers::pi * (i + 1) / (kNeedles + 2);
        return {std::cos(angle) - 1, std::sin(angle), 0};
      };
      const double part = row > 0 ? double(k - needle * row) / row : 0;
      points.push_back(double(row) / kRows * ((1 - part) * corner(needle) + part * corner(needle + 1)));
    }
  }
  std::vector<std::array<VertexId, 3>> faces;
  for (int row = 0; row < kRows; ++row) {
    for (int needle = 0; needle < kNeedles; ++needle) {
      for (int k = 0; k <= row; ++k) {
        const int above = row_start[row] + needle * row + k, below = row_start[row + 1] + needle * (row + 1) + k;
        faces.push_back({VertexId(above), VertexId(below), VertexId(below + 1)});
        if (k < row) faces.push_back({VertexId(above), VertexId(below + 1), VertexId(above + 1)});
      }
    }
  }
  const Mesh mesh(points, faces);
  const auto chosen = sample(mesh, Sampling::farthest, 20);
  CHECK(chosen.size() == 20);
  CHECK(all_distinct(mesh, chosen));
}
