#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "segment/region_topology.hpp"
#include "segment/two_pieces.hpp"
#include "segment_steps.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_smooth_borders {

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

using Labels = IdVector<FaceId, GeneratorId>;

Segmentation segment(const Mesh& mesh, const Diagram& diagram, FaceLabels labels) {
  return segment_faces(mesh, diagram, {labels});
}

/// What smoothing chooses, from the nearest labels.
struct Smoothing {
  Mesh mesh;
  Diagram diagram;
  FaceShares shares;
  Segmentation nearest, smooth;
  FreeFaces free;

  Smoothing(const Mesh& m, const std::vector<SurfacePoint>& generators)
      : mesh(m),
        diagram(compute_diagram(m, generators)),
        shares(diagram),
        nearest(segment(m, diagram, FaceLabels::nearest)),
        smooth(segment(m, diagram, FaceLabels::smooth)),
        free(mesh, diagram, shares, nearest.face_label) {}
};

void require_allowed_labels(const Smoothing& s) {
  int smoothed = 0;
  for (int i = 0; i < s.mesh.face_count(); ++i) {
    const FaceId f(i);
    if (s.smooth.face_label[f] == s.nearest.face_label[f]) continue;
    ++smoothed;
    REQUIRE_FALSE(s.diagram.face_label[f].valid());
    REQUIRE(s.shares.of(f).size() > 1);
    REQUIRE(s.shares.fraction(f, s.smooth.face_label[f]) > 0);
  }
  REQUIRE(s.smooth.smoothed_faces == smoothed);
  REQUIRE(s.nearest.smoothed_faces == 0);
}

void require_same_topology(const Smoothing& s) {
  const auto before = test::find_topology(s.mesh, s.nearest.face_label);
  const auto after = test::find_topology(s.mesh, s.smooth.face_label);
  REQUIRE(before.size() == after.size());
  for (const auto& [g, region] : after) {
    CAPTURE(g.value());
    REQUIRE(region.components == before.at(g).components);
    REQUIRE(region.euler_characteristic == before.at(g).euler_characteristic);
  }
}

/// No face can take another label that shortens the border and keeps the topology.
void require_no_single_gain(const Smoothing& s) {
  const Labels& label = s.smooth.face_label;
  const BorderCosts costs(s.mesh, s.free, label);
  for (int i = 0; i < s.free.count(); ++i) {
    for (const FaceShare& share : s.free.candidates(FreeFaceId(i))) {
      if (share.generator == label[s.free.face(FreeFaceId(i))]) continue;
      if (!keeps_topology(s.mesh, label, s.free.face(FreeFaceId(i)), share.generator)) continue;
      REQUIRE(costs.change(FreeFaceId(i), share.generator) >= -1e-6 * s.mesh.mean_edge_length());
    }
  }
}

double length(const Smoothing& s, const Segmentation& segmentation) {
  return compute_border_length(s.mesh, segmentation.face_label);
}

TEST_CASE("smooth borders: no longer, same topology, only labels with a share, no face to improve") {
  for (const auto& [name, mesh] : test::small_family()) {
    for (const int count : {1, 2, 7, 40, 150}) {
      for (unsigned seed = 0; seed < 2; ++seed) {
        CAPTURE(name, count, seed);
        const Smoothing s(mesh, test::random_generators(mesh, count, seed));
        REQUIRE(length(s, s.smooth) <= length(s, s.nearest) * (1 + 1e-12));
        REQUIRE(s.smooth.without_face == s.nearest.without_face);
        require_allowed_labels(s);
        require_same_topology(s);
        require_no_single_gain(s);
      }
    }
  }
}

TEST_CASE("smooth borders: on a fine mesh they are nearly as long as the bisectors") {
  for (const Mesh& mesh : {test::make_bumpy_sphere(4, 1), test::make_torus(60, 30)}) {
    const Smoothing s(mesh, test::random_generators(mesh, 12, 5));
    CHECK(length(s, s.nearest) > 1.25 * s.diagram.length);
    CHECK(length(s, s.smooth) < 1.1 * s.diagram.length);
  }
}

TEST_CASE("smooth borders: the same labels on another number of threads, and in units of another size") {
  const Mesh mesh = test::make_bumpy_sphere(3, 2);
  const auto generators = test::random_generators(mesh, 20, 1);
  DiagramOptions one, three;
  one.threads = 1;
  three.threads = 3;
  const auto label = [&](const Mesh& m, const DiagramOptions& options) {
    return segment(m, compute_diagram(m, generators, options), FaceLabels::smooth).face_label;
  };
  const Labels expected = label(mesh, one);
  CHECK(label(mesh, three) == expected);
  CHECK(label(test::scaled(mesh, std::ldexp(1, 100)), one) == expected);
  CHECK(label(test::scaled(mesh, std::ldexp(1, -100)), one) == expected);
}

TEST_CASE("smooth borders: a tooth between two straight sides goes") {
  // Three rows of four squares. The first two rows belong to 0, but a face at their end has a larger share of 1.
  constexpr FaceId kTooth(11);
  const Mesh mesh = test::make_grid(4, 3);
  std::vector<GeneratorId> labels(24, GeneratorId(0));
  for (int f = 16; f < 24; ++f) labels[f] = GeneratorId(1);
  Diagram diagram = test::make_whole_diagram(
      mesh, {make_surface_point(FaceId(0), {0.2, 0.3, 0.5}), make_surface_point(FaceId(23), {0.2, 0.3, 0.5})});
  diagram.face_label = Labels(labels);
  test::cut_in_two(diagram, kTooth, 0.8, GeneratorId(1), GeneratorId(0));
  const Segmentation nearest = segment(mesh, diagram, FaceLabels::nearest);
  const Segmentation smooth = segment(mesh, diagram, FaceLabels::smooth);
  CHECK(nearest.face_label[kTooth] == GeneratorId(1));
  CHECK(smooth.face_label[kTooth] == GeneratorId(0));
  CHECK(smooth.smoothed_faces == 1);
  CHECK(compute_border_length(mesh, smooth.face_label) == Approx(4));
}

TEST_CASE("border length: of edges between labels, unlabelled faces among them, and not of the boundary") {
  const Mesh mesh = test::make_grid(1, 1);
  CHECK(compute_border_length(mesh, Labels(2, GeneratorId(0))) == 0);
  CHECK(compute_border_length(mesh, Labels(std::vector<GeneratorId>{GeneratorId(0), GeneratorId(1)})) ==
        Approx(std::sqrt(2)));
  CHECK_THROWS(compute_border_length(mesh, Labels(1, GeneratorId(0))));
}

/// The least cost of all labels that keep the topology, tried one after the other.
class BruteForce {
 public:
  explicit BruteForce(const Smoothing& s)
      : s_(s), costs_(s.mesh, s.free, label_), label_(s.nearest.face_label), topology_(measure(label_)) {}

  double run() {
    search(0, 0);
    return least_;
  }

  double cost(const Labels& label) const {
    double sum = compute_border_length(s_.mesh, label);
    for (int i = 0; i < s_.free.count(); ++i) {
      const FaceId f = s_.free.face(FreeFaceId(i));
      sum += costs_.of_share(FreeFaceId(i), s_.shares.fraction(f, label[f]));
    }
    return sum;
  }

 private:
  std::vector<std::array<int, 3>> measure(const Labels& label) const {
    std::vector<std::array<int, 3>> found;
    for (const auto& [g, region] : test::find_topology(s_.mesh, label)) {
      found.push_back({g.value(), region.components, region.euler_characteristic});
    }
    return found;
  }

  void search(int next, int changed) {
    if (next == s_.free.count()) {
      const double found = cost(label_);
      if (found < least_ && measure(label_) == topology_) least_ = found;
      return;
    }
    const FaceId f = s_.free.face(FreeFaceId(next));
    for (const FaceShare& share : s_.free.candidates(FreeFaceId(next))) {
      label_[f] = share.generator;
      search(next + 1, changed + 1);
    }
  }

  const Smoothing& s_;
  BorderCosts costs_;
  Labels label_;
  std::vector<std::array<int, 3>> topology_;
  double least_ = std::numeric_limits<double>::infinity();
};

double count_choices(const FreeFaces& free) {
  double choices = 1;
  for (int i = 0; i < free.count(); ++i) choices *= static_cast<double>(free.candidates(FreeFaceId(i)).size());
  return choices;
}

TEST_CASE("smooth borders: on tiny meshes nearly always the shortest of all") {
  int tried = 0, shortest = 0;
  for (const Mesh& mesh : {test::make_sphere(0), test::make_jittered_grid(4, 3, 0.2, 1), test::make_tetrahedron(),
                           test::make_ring(6, 2), test::make_jittered_grid(7, 1, 0.2, 2)}) {
    for (const int count : {2, 3, 4}) {
      for (unsigned seed = 0; seed < 12; ++seed) {
        const Smoothing s(mesh, test::random_generators(mesh, count, seed));
        if (count_choices(s.free) > 5000) continue;
        CAPTURE(mesh.face_count(), count, seed);
        BruteForce all(s);
        const double found = all.cost(s.smooth.face_label), least = all.run();
        REQUIRE(found >= least * (1 - 1e-12));
        CHECK(found <= 1.5 * least);
        ++tried;
        shortest += found <= least * (1 + 1e-9);
      }
    }
  }
  CAPTURE(tried, shortest);
  CHECK(tried > 50);
  CHECK(shortest >= 0.93 * tried);
}

}  // namespace gvd::test_smooth_borders
