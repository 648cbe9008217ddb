#include <cmath>
#include <limits>

#include "border_costs.hpp"
#include "keeps_topology.hpp"
#include "segment/region_topology.hpp"
#include "segment/two_pieces.hpp"
#include "smooth_borders.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_smooth_borders {

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
