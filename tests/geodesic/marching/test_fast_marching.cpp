#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "geodesic/marching/fast_marching.hpp"
#include "geodesic/marching/local_update.hpp"
#include "gvd/error.hpp"
#include "support/brute_force.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/models.hpp"
#include "support/simple_obj.hpp"
#include "support/stages.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_fast_marching {

/// Distances carry a symbolic offset of up to 1e-9 mean edges, here about 1.2, which no circle fits exactly.
constexpr double kOffset = 5e-9;

constexpr std::array<Front, 2> kFronts{Front::circle, Front::planar};

/// Distance from generator g to v, without its offset; infinity where the march did not bring it there.
double distance(const FastMarchingResult& marched, VertexId v, GeneratorId g) {
  const std::int32_t item = marched.table.find(v, g);
  if (item < 0) return std::numeric_limits<double>::infinity();
  return marched.table.distance(item).distance - marched.offset.of(g);
}

/// Largest difference to the straight distance on a flat convex mesh with generator 0 alone, in mesh units.
double largest_flat_error(const Mesh& mesh, const SurfacePoint& generator, Front front) {
  const WorkingMesh working(mesh, {generator});
  const FastMarchingResult marched = march(working, front, {});
  const Vec3 from = position(mesh, generator);
  double largest = 0;
  for (int i = 0; i < mesh.vertex_count(); ++i) {
    const double straight = (mesh.position(VertexId(i)) - from).norm();
    largest = std::max(largest, std::abs(distance(marched, VertexId(i), GeneratorId(0)) - straight));
  }
  return largest;
}

TEST_CASE("a single triangle: distances along its edges") {
  const Mesh mesh = test::make_triangle();
  for (const Front front : kFronts) {
    const WorkingMesh working(mesh, test::at_vertices(mesh, {0}));
    const FastMarchingResult marched = march(working, front, {});
    CHECK(distance(marched, VertexId(0), GeneratorId(0)) == 0);
    CHECK(distance(marched, VertexId(1), GeneratorId(0)) == Approx(2));
    CHECK(distance(marched, VertexId(2), GeneratorId(0)) == Approx(std::hypot(0.5, 1.5)));
    CHECK(marched.table.entry_count() == 1);
    CHECK(marched.events == 1);
  }
}

TEST_CASE("planar fronts: a generator inside a face is exactly as far from the corners across its edges") {
  const Mesh mesh = test::make_grid(6, 6);
  const FaceId inside(2 * (3 * 6 + 3));
  const SurfacePoint generator = make_surface_point(inside, {0.3, 0.3, 0.4});
  const WorkingMesh working(mesh, {generator});
  const FastMarchingResult marched = march(working, Front::planar, {});
  for (int corner = 0; corner < 3; ++corner) {
    const VertexId v = mesh.opposite(mesh.twin(Mesh::halfedge(inside, corner)));
    const double straight = (mesh.position(v) - position(mesh, generator)).norm();
    CHECK(std::abs(distance(marched, v, GeneratorId(0)) - straight) < kOffset);
  }
}

TEST_CASE("circle fronts are exact on a flat grid, from a vertex, an edge and a face") {
  const Mesh mesh = test::make_grid(20, 13);
  for (const SurfacePoint& generator :
       {vertex_point(mesh, VertexId(5 * 21 + 7)), vertex_point(mesh, VertexId(0)),
        edge_point(Mesh::halfedge(FaceId(177), 2), 0.3), make_surface_point(FaceId(211), {0.2, 0.3, 0.5})}) {
    CHECK(largest_flat_error(mesh, generator, Front::circle) < kOffset);
  }
}

/// Relative errors of the nearest distances at the vertices of a reference mesh, all generators in one run.
struct NearestError {
  double mean = 0, over = 0, under = 0;  ///< under: how far below the exact distance at the most, as a positive number
};

NearestError nearest_error(const test::Reference& reference, Front front) {
  std::vector<SurfacePoint> generators;
  for (const VertexId v : reference.generators) generators.push_back(vertex_point(reference.mesh, v));
  const test::Stages stages(reference.mesh, generators, front);
  const test::Nearest exact = test::compute_nearest(reference.distances);
  NearestError error;
  int count = 0;
  for (int i = 0; i < reference.mesh.vertex_count(); ++i) {
    const VertexId v(i);
    if (exact.distance[v] == 0) continue;
    const double offset = stages.marched.offset.of(stages.labels.label[v]);
    const double relative = (stages.labels.distance[v] - offset) / exact.distance[v] - 1;
    error.mean += std::abs(relative);
    error.over = std::max(error.over, relative);
    error.under = std::max(error.under, -relative);
    ++count;
  }
  error.mean /= count;
  return error;
}

TEST_CASE("nearest distances at the vertices agree with the reference distances") {
  // Measured: circle 0.01 to 0.3 % on an average, planar 2 to 7 %. Below the exact one by 7 % at worst, on rotor:
  // a circle is unfolded from two distances whose paths pass different sides of a saddle vertex.
  struct Bound {
    const char* name;
    Front front;
    double mean, under;
  };
  for (const Bound& bound :
       {Bound{"spot.m30", Front::circle, 0.0026, 0.065}, Bound{"spot.m30", Front::planar, 0.05, 0.002},
        Bound{"rotor.m15", Front::circle, 0.0028, 0.087}, Bound{"rotor.m15", Front::planar, 0.063, 0},
        Bound{"eight.m10", Front::circle, 0.0032, 0.02}, Bound{"plate.m12", Front::circle, 2e-5, 0.008}}) {
    const auto reference = test::find_reference(bound.name);
    if (!reference) continue;
    const NearestError error = nearest_error(*reference, bound.front);
    INFO(bound.name << ", " << test::name(bound.front));
    CHECK(error.mean <= bound.mean);
    CHECK(error.under <= bound.under + 1e-9);
  }
}

/// Calls visit(winner, loser) for each two entries of a face of which the first defeats the second by equation (3), and
/// is not dominated.
template <class Visit>
void for_each_defeat(const GeneratorTable& table, FaceId f, Visit visit) {
  table.for_each(f, [&](const TableEntry& winner) {
    if (winner.dominated) return;
    const auto w = table.corner_distances(winner);
    table.for_each(f, [&](const TableEntry& loser) {
      const auto l = table.corner_distances(loser);
      if (w[0] < l[0] && w[1] < l[1] && w[2] < l[2]) visit(winner, loser);
    });
  });
}

TEST_CASE("a defeated generator stops: the tables stay small") {
  const Mesh figure = test::read_simple_obj(std::string(GVD_SOURCE_DIR) + "/data/figure.obj");
  for (const auto& marcher : {march, march_in_order}) {
    for (const Front front : kFronts) {
      const WorkingMesh working(figure, test::random_generators(figure, 30, 1));
      const FastMarchingResult marched = marcher(working, front, {});
      int kept = 0;
      for (const FaceId f : working.mesh().faces()) {
        marched.table.for_each(f, [&](const TableEntry& entry) { kept += entry.dominated ? 0 : 1; });
      }
      const double faces = working.mesh().face_count();
      INFO(kept / faces << ", " << double(marched.table.entry_count()) / faces);
      CHECK(kept > 1.15 * faces);
      CHECK(kept < 1.3 * faces);
      CHECK(double(marched.table.entry_count()) < 1.75 * faces);
    }
  }
}

TEST_CASE("a defeated generator stops: it goes a few edges beyond its cell") {
  const Mesh mesh = test::make_grid(40, 3);
  for (const auto& marcher : {march, march_in_order}) {
    for (const Front front : kFronts) {
      const WorkingMesh working(mesh, test::at_vertices(mesh, {41, 41 + 40}));  // at x = 0 and x = 40
      const FastMarchingResult marched = marcher(working, front, {});
      double farthest = 0;
      for (const VertexId v : mesh.vertices()) {
        if (marched.table.find(v, GeneratorId(0)) >= 0) farthest = std::max(farthest, mesh.position(v).x());
      }
      INFO(farthest);
      CHECK(farthest >= 20);
      CHECK(farthest <= 24);
    }
  }
}

TEST_CASE("equation (3) is about the corners alone, and what it defeats is not nearer at a midpoint") {
  int defeats = 0;
  for (const auto& [name, mesh] : test::small_family()) {
    for (const Front front : kFronts) {
      INFO(name << ", " << test::name(front));
      const test::Stages stages(mesh, test::random_generators(mesh, 20, 5), front);
      const GeneratorTable& table = stages.table();
      for (const FaceId f : stages.mesh().faces()) {
        for_each_defeat(table, f, [&](const TableEntry& winner, const TableEntry& loser) {
          for (std::size_t side = 0; side < 3; ++side) {
            const MedianHalves halves = make_median_halves(stages.mesh().shape(f), side);
            REQUIRE(auxiliary_distance(halves, table.corner_distances(winner), side, front) <=
                    auxiliary_distance(halves, table.corner_distances(loser), side, front) + 1e-12);
          }
          ++defeats;
        });
      }
    }
  }
  CHECK(defeats > 1000);
}

/// How many of a table's entries were added before another one whose event has a smaller key, by more than rounding.
/// Those entries are compared that were added to a face with an entry: they lie in the order of their events. The event
/// of such an entry is that of a neighbour with the same generator, the nearest one.
double share_out_of_order(const Mesh& mesh, const GeneratorTable& table) {
  double latest = 0;
  int entries = 0, early = 0;
  for (auto i = static_cast<std::int32_t>(mesh.face_count()); i < static_cast<std::int32_t>(table.entry_count()); ++i) {
    double key = std::numeric_limits<double>::infinity();
    for (const HalfedgeId h : Mesh::halfedges(table.entry(i).face)) {
      const HalfedgeId twin = mesh.twin(h);
      const std::int32_t n = twin.valid() ? table.find(Mesh::face(twin), table.entry(i).generator) : -1;
      if (n < 0 || table.entry(n).dominated) continue;
      const auto d = table.corner_distances(table.entry(n));
      key = std::min(key, d[0] + d[1] + d[2]);
    }
    if (key == std::numeric_limits<double>::infinity()) continue;  // around the generator itself
    ++entries;
    early += key < latest - 1e-9 ? 1 : 0;
    latest = std::max(latest, key);
  }
  return double(early) / entries;
}

TEST_CASE("the paper's queue handles triangles by the sum of their three distances: equation (5)") {
  // Circles on a flat mesh have exact distances, which no later event improves.
  const Mesh mesh = test::make_jittered_grid(30, 30, 0.2, 1);
  std::vector<int> vertices;
  for (int i = 0; i < 40; ++i) vertices.push_back((i * 397 + 11) % mesh.vertex_count());
  const WorkingMesh working(mesh, test::at_vertices(mesh, vertices));
  const double in_order = share_out_of_order(mesh, march_in_order(working, Front::circle, {}).table);
  const double in_buckets = share_out_of_order(mesh, march(working, Front::circle, {}).table);
  INFO(in_order << ", in buckets " << in_buckets);
  CHECK(in_order < 0.05);
  CHECK(in_buckets > 0.5);
}

/// A prism over a regular polygon whose caps are zigzags of needles, as ear clipping leaves them.
Mesh make_zigzag_prism(int sides) {
  std::vector<Vec3> positions;
  for (const double z : {0.0, 0.2}) {
    for (int i = 0; i < sides; ++i) {
      const double angle = 2 * std::acos(-1.0) * i / sides;
      positions.emplace_back(std::cos(angle), std::sin(angle), z);
    }
  }
  std::vector<std::array<VertexId, 3>> faces;
  const auto add = [&](int a, int b, int c) { faces.push_back({VertexId(a), VertexId(b), VertexId(c)}); };
  for (int i = 0; i < sides; ++i) {
    const int next = (i + 1) % sides;
    add(i, next, sides + next);
    add(i, sides + next, sides + i);
  }
  for (int first = 0, last = sides - 1; last - first > 1;) {
    add(sides + first, sides + first + 1, sides + last);
    add(first, last, first + 1);
    ++first;
    if (last - first < 2) break;
    add(sides + first, sides + last - 1, sides + last);
    add(first, last, last - 1);
    --last;
  }
  return {std::move(positions), std::move(faces)};
}

TEST_CASE("the work of both queues is bounded by the mesh where thousands of needles meet") {
  const Mesh prism = make_zigzag_prism(600);
  const WorkingMesh working(prism, test::random_generators(prism, 30, 3));
  for (const auto& marcher : {march, march_in_order}) {
    CHECK(marcher(working, Front::planar, {}).events < 100 * std::int64_t{working.mesh().face_count()});
  }
}

TEST_CASE("both queues give nearly the same nearest distances, but not the same tables") {
  std::size_t different = 0;
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const WorkingMesh working(mesh, test::random_generators(mesh, 20, 5));
    const FastMarchingResult buckets = march(working, Front::planar, {});
    const FastMarchingResult ordered = march_in_order(working, Front::planar, {});
    const NearestLabels by_buckets = compute_nearest_labels(working, buckets.table);
    const NearestLabels by_order = compute_nearest_labels(working, ordered.table);
    for (const VertexId v : working.mesh().vertices()) {
      if (!std::isfinite(by_order.distance[v])) continue;
      REQUIRE(by_buckets.distance[v] == Approx(by_order.distance[v]).epsilon(0.02));
    }
    different += buckets.table.entry_count() != ordered.table.entry_count() ? 1 : 0;
  }
  CHECK(different > 0);
}

TEST_CASE("the indices of the tables are consistent on every family") {
  for (const auto& [name, mesh] : test::small_family()) {
    for (const Front front : kFronts) {
      INFO(name << ", " << test::name(front));
      const test::Stages stages(mesh, test::random_generators(mesh, 20, 5), front);
      const GeneratorTable& table = stages.table();
      for (int i = 0; i < stages.mesh().face_count(); ++i) {
        const FaceId f(i);
        int kept = 0;
        table.for_each(f, [&](const TableEntry& entry) {
          REQUIRE(entry.face == f);
          REQUIRE(table.find(f, entry.generator) >= 0);
          kept += entry.dominated ? 0 : 1;
          for (std::size_t k = 0; k < 3; ++k) {
            REQUIRE(entry.corner[k] == table.find(stages.mesh().vertices(f)[k], entry.generator));
            const double d = table.distance(entry.corner[k]).distance;
            REQUIRE(d >= stages.marched.offset.of(entry.generator));
            REQUIRE(std::isfinite(d));
          }
        });
        if (table.reached(f)) REQUIRE(kept >= 1);
      }
    }
  }
}

TEST_CASE("the distance of a generator's own vertex is its offset, and no other generator's is as small") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const auto generators = test::random_generators(mesh, 20, 6);
    const test::Stages stages(mesh, generators, Front::circle);
    for (int i = 0; i < 20; ++i) {
      const GeneratorId g(i);
      const VertexId v = stages.working.vertex(g);
      const double own = stages.marched.offset.of(GeneratorId(i));
      REQUIRE(stages.table().distance(stages.table().find(v, g)).distance == own);
      stages.table().for_each(v, [&](const VertexDistance& d) { REQUIRE((d.generator == g || d.distance > own)); });
    }
  }
}

TEST_CASE("a distance is at most the length of the path along an edge from the face's other corners") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const test::Stages stages(mesh, test::random_generators(mesh, 5, 7), Front::circle);
    for (int i = 0; i < stages.mesh().face_count(); ++i) {
      stages.table().for_each(FaceId(i), [&](const TableEntry& entry) {
        // A generator that did not propagate from a face need not have reached its corners by the shortest way.
        const auto d = stages.table().corner_distances(entry);
        const std::size_t least = static_cast<std::size_t>(std::min_element(d.begin(), d.end()) - d.begin());
        const double next = stages.mesh().length(Mesh::halfedge(FaceId(i), static_cast<int>(least)));
        const double previous = stages.mesh().length(Mesh::halfedge(FaceId(i), static_cast<int>((least + 2) % 3)));
        if (entry.dominated) return;
        REQUIRE(d[(least + 1) % 3] <= (d[least] + next) * (1 + 1e-9));
        REQUIRE(d[(least + 2) % 3] <= (d[least] + previous) * (1 + 1e-9));
      });
    }
  }
}

TEST_CASE("vertices and faces that no generator reaches have no entry") {
  const Mesh mesh = test::make_two_components();
  const test::Stages stages(mesh, test::at_vertices(mesh, {3}), Front::circle);
  const auto component = compute_face_components(mesh);
  for (int i = 0; i < mesh.face_count(); ++i) {
    REQUIRE(stages.table().reached(FaceId(i)) == (component[FaceId(i)] == component[FaceId(0)]));
  }
}

TEST_CASE("progress is reported from the start, and can cancel") {
  const Mesh mesh = test::make_sphere(2);
  const WorkingMesh working(mesh, test::at_vertices(mesh, {0}));
  int calls = 0;
  march(working, Front::circle, [&](std::string_view step, double fraction) {
    ++calls;
    return step == "distances" && fraction >= 0 && fraction <= 1;
  });
  CHECK(calls >= 1);
  try {
    march(working, Front::circle, [](std::string_view, double) { return false; });
    FAIL("was not cancelled");
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::interrupted);
  }
}

}  // namespace gvd::test_fast_marching
