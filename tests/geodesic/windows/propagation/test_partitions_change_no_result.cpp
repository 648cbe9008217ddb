#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string_view>
#include <vector>

#include "geodesic/face_layout.hpp"
#include "geodesic/nearest_source.hpp"
#include "geodesic/windows/propagation/join_points.hpp"
#include "geodesic/windows/propagation/propagate_windows.hpp"
#include "geodesic/windows/window_sources.hpp"
#include "gvd/error.hpp"
#include "mesh/working_mesh.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/many_threads.hpp"
#include "support/meshes.hpp"

namespace gvd::test_partitions_change_no_result {

/// Sizes of partitions: as many of them as there can be, some, and one.
constexpr std::array<std::int32_t, 4> kPartitionFaces{1, 20, 150, 1 << 20};

WindowField propagate(const WorkingMesh& working, KeepWindows keep, std::int32_t partition_faces, int threads = 1) {
  PropagationOptions options;
  options.keep = keep;
  options.threads = threads;
  options.partition_faces = partition_faces;
  return propagate_windows(working.mesh(), working.generator_vertices().raw(), options, {});
}

std::vector<Window> all_windows(const Mesh& mesh, const WindowField& field) {
  std::vector<Window> windows;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    field.windows.for_each(FaceId(f), [&](const Window& w) { windows.push_back(w); });
  }
  return windows;
}

bool is_same(const Window& a, const Window& b) {
  return a.begin == b.begin && a.end == b.end && a.x == b.x && a.depth == b.depth && a.offset == b.offset &&
         a.generator == b.generator && a.halfedge == b.halfedge;
}

double nearest_distance(const Mesh& mesh, const WindowField& field, FaceId f, const Vec2& at) {
  std::vector<FaceSource> sources;
  collect_face_sources(mesh, field, f, sources);
  double distance = std::numeric_limits<double>::infinity();
  nearest_source(sources, at, distance);
  return distance;
}

TEST_CASE("partitions change no distance") {
  for (const auto& [name, input] : test::small_family()) {
    for (const int count : {1, 9, 60}) {
      const WorkingMesh working(input, test::random_generators(input, count, 21));
      const WindowField whole = propagate(working, KeepWindows::none, 1 << 20);
      for (const std::int32_t partition_faces : kPartitionFaces) {
        INFO(name << " with " << count << " in partitions of " << partition_faces);
        const WindowField field = propagate(working, KeepWindows::none, partition_faces);
        REQUIRE(field.distance.size() == whole.distance.size());
        for (std::size_t v = 0; v < whole.distance.size(); ++v) {
          const double expected = whole.distance.raw()[v];
          if (field.distance.raw()[v] == expected) continue;  // infinity, too
          REQUIRE(std::abs(field.distance.raw()[v] - expected) <= 1e-13 * expected);
        }
        // Messages come a round late, which costs some windows where nearly every vertex is shared.
        if (partition_faces >= 20)
          CHECK(static_cast<double>(field.carried) <= 1.25 * static_cast<double>(whole.carried));
      }
    }
  }
}

TEST_CASE("partitions change no distance from curves, and threads no window") {
  for (const auto& [name, input] : test::small_family()) {
    std::vector<SurfacePoint> points{test::random_generators(input, 1, 3).front()};
    for (const SurfacePoint& next : test::random_generators(input, 6, 4)) {
      try {
        const std::vector<SurfacePoint> between = join_points(input, points.back(), next);
        points.insert(points.end(), between.begin(), between.end());
        points.push_back(next);
      } catch (const Error&) {  // on another component
      }
    }
    const WorkingMesh working(input, std::vector{make_polyline(points, false)});
    const auto propagate_curve = [&](std::int32_t partition_faces, int threads) {
      PropagationOptions options;
      options.threads = threads;
      options.partition_faces = partition_faces;
      return propagate_windows(working, options, {});
    };
    const WindowField whole = propagate_curve(1 << 20, 1);
    for (const std::int32_t partition_faces : kPartitionFaces) {
      CAPTURE(name, partition_faces);
      const WindowField field = propagate_curve(partition_faces, 1);
      for (const VertexId v : working.mesh().vertices()) {
        if (field.distance[v] == whole.distance[v]) continue;  // infinity, too
        CHECK(std::abs(field.distance[v] - whole.distance[v]) <= 1e-13 * whole.distance[v]);
      }
      test::with_many_threads([&] {
        const WindowField again = propagate_curve(partition_faces, 3);
        CHECK(std::ranges::equal(all_windows(working.mesh(), field), all_windows(working.mesh(), again), is_same));
        CHECK(field.distance == again.distance);
      });
    }
  }
}

TEST_CASE("partitions change no label, and of generators that tie the first one wins") {
  std::vector<test::NamedMesh> meshes = test::small_family();
  meshes.push_back({"grid", test::make_grid(24, 24)});
  meshes.push_back({"sphere", test::make_sphere(3)});
  for (const test::NamedMesh& named : meshes) {
    const std::string& name = named.name;
    const Mesh& mesh = named.mesh;
    std::mt19937 random(5);
    for (const int count : {2, 4, 9, 30}) {
      std::vector<VertexId> generators;
      while (static_cast<int>(generators.size()) < std::min(count, mesh.vertex_count())) {
        const VertexId v(random() % static_cast<unsigned>(mesh.vertex_count()));
        if (std::find(generators.begin(), generators.end(), v) == generators.end()) generators.push_back(v);
      }
      PropagationOptions options;
      options.partition_faces = 1 << 20;
      const WindowField whole = propagate_windows(mesh, generators, options, {});
      for (const std::int32_t partition_faces : {1, 10, 60, 150}) {
        INFO(name << " with " << count << " in partitions of " << partition_faces);
        options.partition_faces = partition_faces;
        CHECK(propagate_windows(mesh, generators, options, {}).label == whole.label);
      }
      if (name != "grid") continue;
      for (std::int32_t i = 0; i < mesh.vertex_count(); ++i) {
        // Squares are whole numbers, so no rounding hides which straight lines on the plane are equally long.
        const VertexId v(i);
        const auto squared = [&](VertexId g) { return (mesh.position(g) - mesh.position(v)).squaredNorm(); };
        const auto nearest = std::min_element(generators.begin(), generators.end(),
                                              [&](VertexId a, VertexId b) { return squared(a) < squared(b); });
        CHECK(whole.label[v] == GeneratorId(nearest - generators.begin()));
      }
    }
  }
}

TEST_CASE("with partitions, too, windows near bisectors are all that the faces near them need") {
  for (const auto& [name, input] : test::small_family()) {
    for (const std::int32_t partition_faces : kPartitionFaces) {
      INFO(name << " in partitions of " << partition_faces);
      const WorkingMesh working(input, test::random_generators(input, 9, 21));
      const Mesh& mesh = working.mesh();
      const WindowField all = propagate(working, KeepWindows::all, partition_faces);
      const WindowField near = propagate(working, KeepWindows::near_bisectors, partition_faces);
      CHECK(near.distance == all.distance);
      CHECK(near.label == all.label);
      for (std::int32_t i = 0; i < mesh.face_count(); ++i) {
        const FaceId f(i);
        const FaceLayout layout(mesh, f);
        const auto& [a, b, c] = mesh.vertices(f);
        if (near.label[a] == near.label[b] && near.label[b] == near.label[c]) continue;
        for (const std::array<double, 3>& bary : {std::array{0.3, 0.3, 0.4}, std::array{0.8, 0.1, 0.1}}) {
          const Vec2 at = layout.at(bary);
          REQUIRE(nearest_distance(mesh, near, f, at) == nearest_distance(mesh, all, f, at));
        }
      }
    }
  }
}

TEST_CASE("a vertex between partitions sends windows once") {
  const Mesh mesh = test::make_grid(8, 6);
  for (const std::int32_t partition_faces : kPartitionFaces) {
    for (int v = 0; v < mesh.vertex_count(); ++v) {
      PropagationOptions options;
      options.partition_faces = partition_faces;
      CHECK(propagate_windows(mesh, {VertexId(v)}, options, {}).events == 1);
    }
  }
}

TEST_CASE("any number of threads leaves the same windows, distances and labels to the last bit") {
  test::with_many_threads([] {
    std::vector<test::NamedMesh> meshes = test::small_family();
    meshes.push_back({"large bumpy sphere", test::make_bumpy_sphere(5, 3)});
    for (const auto& [name, input] : meshes) {
      const WorkingMesh working(input, test::random_generators(input, 12, 5));
      for (const KeepWindows keep : {KeepWindows::near_bisectors, KeepWindows::all}) {
        const std::int32_t partition_faces = std::max(input.face_count() / 20, 10);
        const WindowField one = propagate(working, keep, partition_faces, 1);
        const std::vector<Window> windows = all_windows(working.mesh(), one);
        for (const int threads : {2, 3, 8, 8}) {
          INFO(name << " with " << threads << " threads");
          const WindowField field = propagate(working, keep, partition_faces, threads);
          CHECK(field.distance == one.distance);
          CHECK(field.label == one.label);
          CHECK(field.carried == one.carried);
          const std::vector<Window> found = all_windows(working.mesh(), field);
          CHECK(std::equal(found.begin(), found.end(), windows.begin(), windows.end(), is_same));
        }
      }
    }
  });
}

TEST_CASE("propagation in partitions can be cancelled between rounds") {
  const Mesh mesh = test::make_bumpy_sphere(4, 1);
  for (const int threads : {1, 2}) {
    for (const int allowed : {1, 2, 3}) {
      int calls = 0;
      const Progress progress = [&](std::string_view, double fraction) {
        CHECK(fraction >= 0);
        CHECK(fraction <= 1);
        return ++calls < allowed;
      };
      PropagationOptions options;
      options.threads = threads;
      options.partition_faces = 300;
      try {
        propagate_windows(mesh, {VertexId(0)}, options, progress);
        FAIL("not cancelled");
      } catch (const Error& error) {
        CHECK(error.code() == ErrorCode::interrupted);
      }
      CHECK(calls == allowed);
    }
  }
}

}  // namespace gvd::test_partitions_change_no_result
