#include <algorithm>
#include <cmath>
#include <map>

#include "region_topology.hpp"
#include "segment/plain_topology.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_region_topology {

using Labels = FaceLabelling;

constexpr GeneratorId kA(0), kB(1), kC(2);

bool keeps_topology(const Mesh& mesh, Labels label, FaceId f, GeneratorId to) {
  return RegionTopology(mesh, label).allows(f, to);
}

/// The most intervals of faces with label g round one vertex.
int most_runs(const Mesh& mesh, const Labels& label, GeneratorId g) {
  std::map<VertexId, int> ends;
  for (int h = 0; h < mesh.halfedge_count(); ++h) {
    const HalfedgeId twin = mesh.twin(HalfedgeId(h));
    if (label[Mesh::face(HalfedgeId(h))] != g || (twin.valid() && label[Mesh::face(twin)] == g)) continue;
    ++ends[mesh.from(HalfedgeId(h))], ++ends[mesh.to(HalfedgeId(h))];
  }
  int most = 0;
  for (const auto& [v, count] : ends) most = std::max(most, count / 2);
  return most;
}

/// Labels that grow from random faces, a face at a time, so that they are connected but of any shape.
Labels grow_labels(const Mesh& mesh, int regions, unsigned seed) {
  test::Random random(seed);
  Labels label(static_cast<std::size_t>(mesh.face_count()));
  std::vector<FaceId> front;
  for (int g = 0; g < regions; ++g) {
    const FaceId f(random.below(mesh.face_count()));
    if (label[f].valid()) continue;
    label[f] = GeneratorId(g);
    front.push_back(f);
  }
  while (!front.empty()) {
    const std::size_t pick = static_cast<std::size_t>(random.below(static_cast<int>(front.size())));
    std::vector<FaceId> next;
    for (int corner = 0; corner < 3; ++corner) {
      const HalfedgeId twin = mesh.twin(Mesh::halfedge(front[pick], corner));
      if (twin.valid() && !label[Mesh::face(twin)].valid()) next.push_back(Mesh::face(twin));
    }
    if (next.empty()) {
      front.erase(front.begin() + static_cast<std::ptrdiff_t>(pick));
      continue;
    }
    const FaceId f = next[random.below(static_cast<int>(next.size()))];
    label[f] = label[front[pick]];
    front.push_back(f);
  }
  return label;
}

Labels of(const std::vector<GeneratorId>& labels) { return Labels(labels); }

TEST_CASE("region topology: the smallest cases") {
  const Mesh triangle = test::make_triangle();
  CHECK_FALSE(keeps_topology(triangle, of({kA}), FaceId(0), kB));
  const Mesh pillow = test::make_pillow();
  CHECK_FALSE(keeps_topology(pillow, of({kA, kA}), FaceId(0), kB));
  CHECK_FALSE(keeps_topology(pillow, of({kA, kB}), FaceId(0), kB));  // kA would vanish
  const Mesh square = test::make_grid(1, 1);
  CHECK_FALSE(keeps_topology(square, of({kA, kB}), FaceId(0), kB));
  const Mesh tetrahedron = test::make_tetrahedron();
  CHECK(keeps_topology(tetrahedron, of({kA, kA, kB, kB}), FaceId(0), kB));
  CHECK_FALSE(keeps_topology(tetrahedron, of({kA, kA, kB, kB}), FaceId(0), kC));  // no neighbour has it
  CHECK_FALSE(keeps_topology(tetrahedron, of({kA, kB, kB, kB}), FaceId(0), kB));
}

TEST_CASE("region topology: the inner face of a strip is its only bridge") {
  const Mesh strip = test::make_grid(3, 1);                                         // faces 1 0 3 2 5 4 in a row
  CHECK_FALSE(keeps_topology(strip, of({kA, kA, kB, kA, kB, kB}), FaceId(0), kB));  // 1 would be cut off from 3
  CHECK(keeps_topology(strip, of({kA, kA, kB, kA, kB, kB}), FaceId(3), kB));
  CHECK_FALSE(keeps_topology(strip, of({kA, kA, kB, kA, kB, kB}), FaceId(4), kA));
}

TEST_CASE("region topology: a region does not touch itself at a vertex") {
  // Six faces round the middle vertex of a hexagon.
  std::vector<Vec3> positions{{0, 0, 0}};
  std::vector<std::array<int, 3>> faces;
  for (int i = 0; i < 6; ++i) {
    positions.emplace_back(std::cos(i * 1.0471975511965976), std::sin(i * 1.0471975511965976), 0);
    faces.push_back({0, i + 1, (i + 1) % 6 + 1});
  }
  const Mesh hexagon = test::make_mesh(positions, faces);
  CHECK(keeps_topology(hexagon, of({kA, kA, kA, kB, kB, kB}), FaceId(0), kB));
  CHECK_FALSE(keeps_topology(hexagon, of({kA, kA, kA, kA, kA, kB}), FaceId(2), kB));  // not beside it
  CHECK_FALSE(keeps_topology(hexagon, of({kA, kC, kB, kC, kC, kC}), FaceId(0), kB));
  CHECK_FALSE(keeps_topology(hexagon, of({kB, kC, kB, kC, kC, kC}), FaceId(1), kB));  // two parts would join
}

TEST_CASE("region topology: a vertex with many faces decides as one with few") {
  for (const int sides : {10, kLongestFan + 1, 1000}) {
    CAPTURE(sides);
    const Mesh pyramid = test::make_pyramid(200, sides);  // the sides belong to kA, the base to kB
    Labels label(static_cast<std::size_t>(pyramid.face_count()), kA);
    for (int f = sides; f < 2 * sides; ++f) label[FaceId(f)] = kB;
    RegionTopology topology(pyramid, label);
    CHECK(topology.allows(FaceId(5), kB));  // its tip has no other face of kB
    topology.relabel(FaceId(5), kB);
    CHECK_FALSE(topology.allows(FaceId(8), kB));  // kB would touch itself at the tip
    CHECK(topology.allows(FaceId(6), kB));
    CHECK(topology.allows(FaceId(5), kA));
    topology.relabel(FaceId(5), kA);
    CHECK(topology.allows(FaceId(8), kB));
    for (int f = 0; f + 2 < sides; ++f) topology.relabel(FaceId(f), kB);
    CHECK(topology.allows(FaceId(sides - 2), kB));
    topology.relabel(FaceId(sides - 2), kB);
    CHECK_FALSE(topology.allows(FaceId(sides - 1), kB));  // kA would vanish
  }
}

TEST_CASE("region topology: whatever it allows changes the topology of no region") {
  int allowed = 0;
  for (const auto& [name, mesh] : test::small_family()) {
    for (unsigned seed = 0; seed < 3; ++seed) {
      Labels label = grow_labels(mesh, 6, seed);
      if (std::any_of(label.begin(), label.end(), [](GeneratorId g) { return !g.valid(); })) continue;
      test::Random random(seed);
      for (int trial = 0; trial < 500; ++trial) {
        const FaceId f(random.below(mesh.face_count()));
        const GeneratorId from = label[f], to(random.below(6));
        if (from == to || !keeps_topology(mesh, label, f, to)) continue;
        CAPTURE(name, seed, trial);
        ++allowed;
        auto before = test::find_topology(mesh, label);
        const int runs = std::max(1, most_runs(mesh, label, to)), runs_from = most_runs(mesh, label, from);
        label[f] = to;
        auto after = test::find_topology(mesh, label);
        for (const GeneratorId g : {from, to}) {
          REQUIRE(after[g].components == before[g].components);
          REQUIRE(after[g].euler_characteristic == before[g].euler_characteristic);
        }
        REQUIRE(most_runs(mesh, label, to) <= runs);
        REQUIRE(most_runs(mesh, label, from) <= runs_from);
      }
    }
  }
  CHECK(allowed > 300);
}

/// Up to `count` connected faces that all pass to one label.
std::vector<FaceChange> pick_changes(const Mesh& mesh, const Labels& label, int count, test::Random& random) {
  const GeneratorId to = label[FaceId(random.below(mesh.face_count()))];
  std::vector<FaceChange> changes;
  FaceId f(random.below(mesh.face_count()));
  for (int step = 0; step < 3 * count && std::ssize(changes) < count; ++step) {
    const bool is_new = std::ranges::find(changes, f, &FaceChange::face) == changes.end();
    if (is_new && label[f] != to) changes.push_back({f, to});
    const HalfedgeId twin = mesh.twin(Mesh::halfedge(f, random.below(3)));
    if (twin.valid() && label[Mesh::face(twin)] != to) f = Mesh::face(twin);
  }
  return changes;
}

TEST_CASE("region topology: many faces change together exactly where the topology of all regions stays") {
  int allowed = 0, refused = 0, only_together = 0;
  for (const Mesh& mesh : {test::make_sphere(0), test::make_sphere(1), test::make_torus(8, 4), test::make_ring(8, 2),
                           test::make_grid(5, 4), test::make_pyramid(300, 9)}) {
    for (unsigned seed = 0; seed < 6; ++seed) {
      Labels label = grow_labels(mesh, 5, seed);
      if (std::any_of(label.begin(), label.end(), [](GeneratorId g) { return !g.valid(); })) continue;
      test::Random random(seed);
      for (int trial = 0; trial < 100; ++trial) {
        const std::vector<FaceChange> changes = pick_changes(mesh, label, 1 + random.below(5), random);
        if (changes.empty()) continue;
        CAPTURE(mesh.face_count(), seed, trial, changes.size());
        const Labels before = label;
        Labels after = label;
        for (const auto& [f, to] : changes) after[f] = to;
        RegionTopology topology(mesh, label);
        const bool single = std::ranges::any_of(changes, [&](auto c) { return topology.allows(c.face, c.label); });
        const bool changed = topology.relabel_together(changes);
        REQUIRE(changed == test::has_same_topology(mesh, before, after));
        REQUIRE(label == (changed ? after : before));
        allowed += changed;
        refused += !changed;
        only_together += changed && !single;
      }
    }
  }
  CAPTURE(allowed, refused, only_together);
  CHECK(allowed > 100);
  CHECK(refused > 100);
  CHECK(only_together > 0);
}

TEST_CASE("region search: targets that are connected, apart, or the same face") {
  const Mesh strip = test::make_grid(3, 1);  // faces 1 0 3 2 5 4 in a row
  const Labels label = of({kA, kA, kA, kB, kA, kA});
  RegionSearch search(strip, label);
  const std::vector<FaceId> one{FaceId(4), FaceId(4)}, near{FaceId(2), FaceId(4)}, apart{FaceId(0), FaceId(2)};
  CHECK(search.connects(one));
  CHECK(search.visited_faces() <= 1);
  CHECK(search.connects(near));
  CHECK_FALSE(search.connects(apart));
}

}  // namespace gvd::test_region_topology
