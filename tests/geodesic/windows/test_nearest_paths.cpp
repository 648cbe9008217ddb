#include <cmath>
#include <random>

#include "geodesic/windows/nearest_paths.hpp"
#include "geodesic/windows/propagation/propagate_windows.hpp"
#include "gvd/exact_field.hpp"
#include "gvd/geodesic_tracing.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_nearest_paths {

/// The paths from some generators, and the input's faces that they leave whole.
struct Setup {
  Setup(const Mesh& of, const std::vector<SurfacePoint>& at)
      : mesh(of),
        working(mesh, at),
        field(propagate_windows(working.mesh(), working.generator_vertices().raw(), options(), {})),
        departures(working, at) {}

  static PropagationOptions options() {
    PropagationOptions options;
    options.departures = true;
    return options;
  }
  NearestPaths paths() const { return {working.mesh(), field, departures}; }

  const Mesh& mesh;
  WorkingMesh working;
  WindowField field;
  Departures departures;
};

/// Whether a path passes through a vertex.
bool bends(const GeodesicPath& path) {
  for (std::size_t i = 1; i + 1 < path.points.size(); ++i) {
    if (path.points[i].kind() == SurfacePoint::Kind::vertex) return true;
  }
  return false;
}

Bary random_bary(std::mt19937& random) {
  const auto real = [&] { return (1 + static_cast<double>(random() % 9998)) / 1e4; };
  const double u = real(), v = (1 - u) * real();
  return {1 - u - v, u, v};
}

/// Whether a face has a vertex of the face of a generator.
IdVector<FaceId, bool> faces_at(const Mesh& mesh, const std::vector<SurfacePoint>& generators) {
  IdVector<VertexId, bool> is_near(static_cast<std::size_t>(mesh.vertex_count()), false);
  for (const SurfacePoint& p : generators) {
    for (const VertexId v : mesh.vertices(p.face)) is_near[v] = true;
  }
  IdVector<FaceId, bool> faces;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const auto& [a, b, c] = mesh.vertices(FaceId(f));
    faces.push_back(is_near[a] || is_near[b] || is_near[c]);
  }
  return faces;
}

/// Sum of the squared distances of one point in each face but some, and its derivative as generator 0 moves along
/// `way`.
struct SampledEnergy {
  double energy = 0, slope = 0;
};

SampledEnergy sample(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const Vec2& way,
                     const IdVector<FaceId, bool>& without) {
  const Setup setup(mesh, generators);
  NearestPaths paths = setup.paths();
  std::mt19937 random(7);
  SampledEnergy sum;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const Bary at = random_bary(random);
    if (without[FaceId(f)]) continue;
    paths.enter(FaceId(f));
    const NearestPath path = paths.at(paths.position(at));
    sum.energy += path.distance * path.distance;
    if (path.generator == GeneratorId(0)) sum.slope -= 2 * path.log.dot(way);
  }
  return sum;
}

TEST_CASE("nearest paths: distance and logarithm are those of the traced shortest path") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    for (unsigned seed = 0; seed < 3; ++seed) {
      const auto generators = test::random_generators(mesh, 1 + 3 * static_cast<int>(seed), seed);
      const Setup setup(mesh, generators);
      const ExactField exact(mesh, generators);
      NearestPaths paths = setup.paths();
      std::mt19937 random(seed);
      int disagreeing = 0;
      for (int i = 0; i < 200; ++i) {
        const FaceId f(random() % static_cast<unsigned>(mesh.face_count()));
        const Bary at = random_bary(random);
        if (setup.working.is_split(f)) continue;
        paths.enter(f);
        const NearestPath path = paths.at(paths.position(at));
        const SurfacePoint point = make_surface_point(f, at);
        const auto nearest = exact.nearest(point);
        REQUIRE(path.generator == nearest.generator);
        if (!path.generator.valid()) continue;
        CHECK(path.distance == Approx(nearest.distance).epsilon(1e-11));
        CHECK(path.log.norm() == Approx(path.distance).epsilon(1e-8));
        const GeodesicPath traced = exact.path(point);
        if (!traced.complete) continue;
        const bool agrees = (path.log - exact.departure(point)).norm() < 1e-6 * path.distance;
        // To the vertex at which a path bends there can be two that are equally long.
        CHECK((agrees || bends(traced)));
        disagreeing += !agrees;
      }
      CHECK(disagreeing <= 3);
    }
  }
}

TEST_CASE("nearest paths: logarithms are the gradient of squared distances, to 1e-6") {
  for (const test::NamedMesh& named : test::small_family()) {
    INFO(named.name);
    const Mesh& mesh = named.mesh;
    for (unsigned seed = 0; seed < 4; ++seed) {
      auto generators = test::random_generators(mesh, 6, seed);
      // On vertices with curvature the energy has no gradient.
      std::swap(generators[0], generators[seed % 2 == 0 ? 1 : 2]);
      const auto without = faces_at(mesh, generators);
      const Vec2 way = unit_vector(1 + seed);
      const double step = 1e-5 * mesh.mean_edge_length();
      const auto moved = [&](double length) {
        auto to = generators;
        const GeodesicTrace trace = trace_geodesic(mesh, generators[0], length * way);
        to[0] = trace.points.back();
        return std::pair(sample(mesh, to, way, without).energy, trace.complete);
      };
      const auto [ahead, whole_ahead] = moved(step);
      const auto [behind, whole_behind] = moved(-step);
      if (!whole_ahead || !whole_behind) continue;  // over the boundary
      const SampledEnergy here = sample(mesh, generators, way, without);
      const double scale = std::sqrt(here.energy * mesh.face_count());
      CHECK((ahead - behind) / (2 * step) == Approx(here.slope).margin(1e-6 * scale));
    }
  }
}

TEST_CASE("nearest paths: from the nearest image comes the shortest path, and none is shorter from another") {
  const Mesh mesh = test::make_bumpy_sphere(2, 3);
  const Setup setup(mesh, test::random_generators(mesh, 8, 1));
  NearestPaths paths = setup.paths();
  std::mt19937 random(5);
  for (std::int32_t f = 0; f < setup.working.mesh().face_count(); ++f) {
    paths.enter(FaceId(f));
    const Vec2 p = paths.position(random_bary(random));
    const NearestPath shortest = paths.at(p);
    const NearestPath same = paths.from(paths.nearest_image(p), p);
    CHECK(same.generator == shortest.generator);
    CHECK(same.distance == shortest.distance);
    CHECK(same.log == shortest.log);
    for (std::size_t image = 0; image < paths.image_count(); ++image) {
      const NearestPath other = paths.from(image, p);
      CHECK(other.generator == paths.generator(image));
      CHECK(other.distance >= shortest.distance);
    }
  }
}

}  // namespace gvd::test_nearest_paths
