#include <algorithm>
#include <cmath>
#include <map>

#include "keeps_topology.hpp"
#include "segment/region_topology.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_keeps_topology {

using Labels = IdVector<FaceId, GeneratorId>;

constexpr GeneratorId kA(0), kB(1), kC(2);

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

TEST_CASE("keeps topology: the smallest cases") {
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

TEST_CASE("keeps topology: the inner face of a strip is its only bridge") {
  const Mesh strip = test::make_grid(3, 1);                                         // faces 1 0 3 2 5 4 in a row
  CHECK_FALSE(keeps_topology(strip, of({kA, kA, kB, kA, kB, kB}), FaceId(0), kB));  // 1 would be cut off from 3
  CHECK(keeps_topology(strip, of({kA, kA, kB, kA, kB, kB}), FaceId(3), kB));
  CHECK_FALSE(keeps_topology(strip, of({kA, kA, kB, kA, kB, kB}), FaceId(4), kA));
}

TEST_CASE("keeps topology: a region does not touch itself at a vertex") {
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

TEST_CASE("keeps topology: a fan without end is not walked round") {
  std::vector<Vec3> positions{{0, 0, 1}};
  std::vector<std::array<int, 3>> faces;
  constexpr int kFaces = 1000;
  for (int i = 0; i < kFaces; ++i) {
    positions.emplace_back(std::cos(i * 6.283185307179586 / kFaces), std::sin(i * 6.283185307179586 / kFaces), 0);
    faces.push_back({0, i + 1, (i + 1) % kFaces + 1});
  }
  const Mesh cone = test::make_mesh(positions, faces);
  Labels label(kFaces, kA);
  for (int i = 500; i < kFaces; ++i) label[FaceId(i)] = kB;
  CHECK(keeps_topology(cone, label, FaceId(499), kB));  // its sides decide
}

TEST_CASE("keeps topology: whatever it allows changes the topology of no region") {
  int allowed = 0;
  for (const auto& [name, mesh] : test::small_family()) {
    for (unsigned seed = 0; seed < 3; ++seed) {
      Labels label = grow_labels(mesh, 6, seed);
      if (std::any_of(label.begin(), label.end(), [](GeneratorId g) { return !g.valid(); })) continue;
      test::Random random(seed);
      for (int trial = 0; trial < 400; ++trial) {
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

}  // namespace gvd::test_keeps_topology
