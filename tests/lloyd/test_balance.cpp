// Weighted diagrams, and weights by which cells have their shares.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "balance_rates.hpp"
#include "balance_search.hpp"
#include "diagram/diagram_windows.hpp"
#include "gvd/check.hpp"
#include "gvd/exact_field.hpp"
#include "gvd/face_regions.hpp"
#include "gvd/segment.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/many_threads.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"
#include "support/refusal.hpp"
#include "support/same_diagram.hpp"
#include "support/samples.hpp"
#include "support/sound_diagram.hpp"

namespace gvd::test_balance {

using test::kInfinity;
using test::refusal;

/// Distances from one generator at a time, which no other generator's windows can hide, with its weight.
class WeightedDistances {
 public:
  WeightedDistances(const Mesh& mesh, const Diagram& diagram) : diagram_(diagram) {
    for (const SurfacePoint& generator : diagram.generators) fields_.emplace_back(mesh, std::vector{generator});
  }
  double at(GeneratorId g, const SurfacePoint& p) const {
    return fields_[g.index()].nearest(p).distance + diagram_.weight(g);
  }
  double least(const SurfacePoint& p) const {
    double least = kInfinity;
    for (std::size_t g = 0; g < fields_.size(); ++g) least = std::min(least, at(GeneratorId(g), p));
    return least;
  }

 private:
  const Diagram& diagram_;
  std::vector<ExactField> fields_;
};

/// Weights of which no two differ by more than `part` of the least distance of two generators.
std::vector<double> random_weights(const Mesh& mesh, const std::vector<SurfacePoint>& generators, double part,
                                   unsigned seed) {
  test::Random random(seed);
  const double bound = part * test::least_spacing(mesh, generators);
  std::vector<double> weights;
  for (std::size_t i = 0; i < generators.size(); ++i) weights.push_back(random.real(-bound / 2, bound / 2));
  return weights;
}

double coefficient_of_variation(const std::vector<double>& values) {
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
  double sum = 0;
  for (const double value : values) sum += (value / mean - 1) * (value / mean - 1);
  return std::sqrt(sum / double(values.size()));
}

TEST_CASE("weights: distances with them tie on bisectors, and no generator is nearer than a cell's own") {
  for (const auto& [name, mesh] : test::small_family()) {
    CAPTURE(name);
    const std::vector<SurfacePoint> generators = test::sample(mesh, Sampling::farthest, 9);
    DiagramOptions options;
    options.weights = random_weights(mesh, generators, 0.8, 3);
    const Diagram diagram = test::compute_sound(mesh, generators, options);
    CHECK(diagram.weights == options.weights);
    const WeightedDistances distances(mesh, diagram);
    const double rounding = 1e-11 * mesh.bbox_diagonal();
    for (const VertexId v : mesh.vertices()) {
      const GeneratorId g = diagram.vertex_label[v];
      if (!g.valid()) continue;
      const SurfacePoint p = vertex_point(mesh, v);
      CHECK(std::abs(distances.at(g, p) - distances.least(p)) <= rounding);
      CHECK(std::abs(diagram.vertex_distance[v] + diagram.weight(g) - distances.least(p)) <= rounding);
    }
    for (const BranchPoint& branch : diagram.branch_points) {
      for (const GeneratorId g : branch.generators) {
        CHECK(std::abs(distances.at(g, branch.point) - branch.distance) <= rounding);
      }
      CHECK(std::abs(distances.least(branch.point) - branch.distance) <= rounding);
    }
    for (const Bisector& bisector : diagram.bisectors) {
      for (const SurfacePoint& p : bisector.points) {
        if (diagram.report.straightened_faces > 0) break;
        CHECK(std::abs(distances.at(bisector.left, p) - distances.at(bisector.right, p)) <=
              1e-7 * mesh.bbox_diagonal());
      }
    }
  }
}

TEST_CASE("weights: only their differences matter, and equal ones change nothing but rounding") {
  const Mesh mesh = test::make_bumpy_sphere(3, 1);
  const std::vector<SurfacePoint> generators = test::random_generators(mesh, 7, 1);
  const Diagram plain = compute_diagram(mesh, generators);
  DiagramOptions options;
  options.weights.assign(7, -3.5);
  CHECK(test::same_diagram(compute_diagram(mesh, generators, options), plain) ==
        false);  // branch points have the weight
  options.weights.assign(7, 0);
  CHECK(test::same_diagram(compute_diagram(mesh, generators, options), plain));
}

TEST_CASE("weights: what is no weight is refused in one line") {
  const Mesh mesh = test::make_sphere(2);
  const std::vector<SurfacePoint> generators = test::sample(mesh, Sampling::farthest, 3);
  DiagramOptions options;
  const auto message = [&](ErrorCode code = ErrorCode::invalid_option) {
    return refusal([&] { compute_diagram(mesh, generators, options); }, code);
  };
  options.weights = {1, 2};
  CHECK(message() == "there are 2 weights for 3 generators; give one for each");
  options.weights = {0, std::nan(""), 0};
  CHECK(message() == "weight 1 is nan; give a finite number");
  options.weights = {0, 0, 4};
  CHECK(message(ErrorCode::precondition) ==
        "generator 2 has no cell, because with these weights generator 0 is nearer even at its place; weights of two "
        "generators must differ by less than their distance");
  options.weights = {0, 0, 0};
  options.method = Method::gbgvd;
  CHECK(message() == "weights need the exact method; choose it, or leave them out");
}

TEST_CASE("balance: weights at the start that hide a generator are told, and refused in one line") {
  const Mesh mesh = test::make_sphere(2);
  const std::vector<SurfacePoint> generators = test::sample(mesh, Sampling::farthest, 3);
  BalanceOptions options;
  options.diagram.weights = {0, 0, 4};
  const auto found = try_to_balance(mesh, generators, options);
  REQUIRE(std::holds_alternative<HiddenGenerator>(found));
  CHECK(std::get<HiddenGenerator>(found).generator == GeneratorId(2));
  CHECK(std::get<HiddenGenerator>(found).nearer == GeneratorId(0));
  CHECK(refusal([&] { balance_cells(mesh, generators, options); }, ErrorCode::precondition) ==
        std::get<HiddenGenerator>(found).error().what());
}

TEST_CASE("balance: all cells have the same area, in the cut mesh too") {
  for (const auto& [name, mesh] : test::small_family()) {
    CAPTURE(name);
    const BalancedDiagram balanced = balance_cells(mesh, test::sample(mesh, Sampling::farthest, 10));
    CHECK(check_diagram(mesh, balanced.diagram).ok());
    // Rounding of polylines ends some runs on coarse meshes at 1e-7, just before they converge.
    CHECK((balanced.converged || balanced.variation <= 1e-6));
    if (name == "two components") continue;  // shares are those of a component
    if (!balanced.tied.empty()) continue;    // coarse meshes have vertices with much surface behind them
    CHECK(coefficient_of_variation(balanced.masses) <= 1e-6);
    const CutMesh cut = cut_faces(mesh, balanced.diagram);
    std::vector<double> areas(10, 0.0);
    for (const FaceId f : cut.mesh.faces()) areas[cut.label[f].index()] += cut.mesh.area(f);
    CHECK(coefficient_of_variation(areas) <= 1e-6);
  }
}

TEST_CASE("balance: on a sphere, a share at a pole ends at its circle of latitude") {
  const Mesh mesh = test::make_sphere(5);
  const auto pole = [&](double z) {
    const auto nearest = std::ranges::max_element(mesh.positions(), {}, [z](const Vec3& p) { return z * p.z(); });
    return vertex_point(mesh, VertexId(nearest - mesh.positions().begin()));
  };
  for (const double share : {0.1, 0.25, 0.5, 0.8}) {
    BalanceOptions options;
    options.shares = {share, 1 - share};
    const BalancedDiagram balanced = balance_cells(mesh, {pole(1), pole(-1)}, options);
    REQUIRE(balanced.converged);
    CHECK(balanced.masses[0] / (balanced.masses[0] + balanced.masses[1]) == Approx(share).epsilon(1e-6));
    const double latitude = std::acos(1 - 2 * share);
    CHECK(balanced.diagram.weights[0] - balanced.diagram.weights[1] ==
          Approx(std::numbers::pi - 2 * latitude).margin(5e-3));
  }
}

TEST_CASE("balance: on a torus, evenly spread generators get equal weights from any start") {
  const Mesh mesh = test::make_torus(24, 12);
  std::vector<SurfacePoint> generators;
  for (const VertexId v : mesh.vertices()) {
    const Vec3& p = mesh.position(v);
    if (p.head<2>().norm() > 1.35 - 1e-9 && v.value() % 4 == 0) generators.push_back(vertex_point(mesh, v));
  }
  REQUIRE(generators.size() >= 3);
  BalanceOptions options;
  options.diagram.weights = random_weights(mesh, generators, 0.5, 7);
  options.tolerance = 1e-10;
  const BalancedDiagram balanced = balance_cells(mesh, generators, options);
  REQUIRE(balanced.converged);
  const auto [least, most] = std::ranges::minmax_element(balanced.diagram.weights);
  CHECK(*most - *least <= 1e-7);
}

TEST_CASE("balance: rates are the derivatives of the masses") {
  for (const unsigned seed : {1u, 2u}) {
    const Mesh mesh = test::make_bumpy_sphere(4, seed);
    const std::vector<SurfacePoint> generators = test::sample(mesh, Sampling::farthest, 8);
    const Density density = make_vertex_density(mesh, [&] {
      std::vector<double> values;
      for (const Vec3& p : mesh.positions()) values.push_back(2 + p.x());
      return values;
    }());
    DiagramOptions options;
    options.chord_tolerance = 1e-8;
    options.weights = random_weights(mesh, generators, 0.3, seed);
    std::vector<double> rates;
    const auto masses = [&](double step) {
      DiagramOptions moved = options;
      moved.weights[2] += step;
      const Diagram diagram = compute_diagram(mesh, generators, moved);
      return compute_cell_masses(mesh, diagram, density);
    };
    const Diagram diagram = compute_diagram_and_read(
        mesh, generators, options, KeepWindows::near_bisectors,
        [&](const WorkingMesh& working, const WindowField& field, const Diagram& found) {
          rates = integrate_balance_rates(working, field, found, density, {1, options.progress});
        });
    const double step = 1e-6;
    const std::vector<double> more = masses(step), less = masses(-step);
    std::vector<double> expected(generators.size(), 0.0);
    for (const BisectorId id : diagram.bisectors.ids()) {
      const std::size_t left = diagram.bisectors[id].left.index(), right = diagram.bisectors[id].right.index();
      for (const auto& [cell, other] : {std::pair(left, right), std::pair(right, left)}) {
        if (cell != 2) continue;
        expected[cell] -= rates[id.index()];
        expected[other] += rates[id.index()];
      }
    }
    for (std::size_t i = 0; i < generators.size(); ++i) {
      CHECK((more[i] - less[i]) / (2 * step) == Approx(expected[i]).margin(2e-3 * std::abs(expected[2])));
    }
  }
}

TEST_CASE("balance: shares, and what is shared, may differ, components keep their mass") {
  const Mesh mesh = test::make_two_components();
  std::vector<double> values;
  for (const Vec3& p : mesh.positions()) values.push_back(1.5 + 0.3 * p.y());
  BalanceOptions options;
  options.density = make_vertex_density(mesh, values);
  const std::vector<SurfacePoint> generators = test::sample(mesh, Sampling::farthest, 12);
  for (std::size_t i = 0; i < generators.size(); ++i) options.shares.push_back(1 + 0.1 * double(i));
  const BalancedDiagram balanced = balance_cells(mesh, generators, options);
  REQUIRE(balanced.converged);
  const auto component = compute_face_components(mesh);
  for (std::size_t i = 1; i < generators.size(); ++i) {
    if (component[generators[i].face] != component[generators[0].face] || !balanced.tied.empty()) continue;
    CHECK(balanced.masses[i] / balanced.masses[0] == Approx(options.shares[i] / options.shares[0]).epsilon(1e-6));
  }
  const double total = std::accumulate(balanced.targets.begin(), balanced.targets.end(), 0.0);
  CHECK(std::accumulate(balanced.masses.begin(), balanced.masses.end(), 0.0) == Approx(total));
}

/// Flat triangles round a vertex with twice the usual angle: half of the surface lies behind it for any path through
/// it.
Mesh make_saddle(int sectors, int rings) {
  std::vector<Vec3> positions{Vec3::Zero()};
  std::vector<std::array<VertexId, 3>> faces;
  const double lift =
      std::sqrt(1 - 0.25);  // every second spoke goes up, the others down: all triangles are equilateral
  for (int r = 1; r <= rings; ++r) {
    for (int s = 0; s < sectors; ++s) {
      const double angle = 2 * std::numbers::pi * s / sectors, height = (s % 2 == 0 ? 1 : -1) * 0.5 * lift;
      const double flat = std::sqrt(1 - height * height);
      positions.emplace_back(r * flat * std::cos(angle), r * flat * std::sin(angle), r * height);
    }
  }
  const auto at = [&](int r, int s) { return VertexId(r == 0 ? 0 : 1 + (r - 1) * sectors + s % sectors); };
  for (int s = 0; s < sectors; ++s) {
    faces.push_back({at(0, 0), at(1, s), at(1, s + 1)});
    for (int r = 1; r < rings; ++r) {
      faces.push_back({at(r, s), at(r + 1, s), at(r + 1, s + 1)});
      faces.push_back({at(r, s), at(r + 1, s + 1), at(r, s + 1)});
    }
  }
  return Mesh(positions, faces);
}

TEST_CASE("balance: cells that can't be told apart behind a saddle are tied, and the others have their shares") {
  const Mesh mesh = make_saddle(12, 6);
  const auto ring = [&](int r, int s) { return vertex_point(mesh, VertexId(1 + (r - 1) * 12 + s)); };
  // Two generators on neighbouring spokes, far from most of the surface, which paths reach through the centre.
  BalanceOptions options;
  const BalancedDiagram balanced = balance_cells(mesh, {ring(3, 0), ring(3, 2)}, options);
  CHECK(check_diagram(mesh, balanced.diagram).ok());
  REQUIRE(balanced.tied.size() == 1);
  CHECK(balanced.tied[0] == std::vector{GeneratorId(0), GeneratorId(1)});
  CHECK(balanced.converged);
  CHECK(balanced.variation > 0.1);
  CHECK(balanced.masses[0] + balanced.masses[1] == Approx(balanced.targets[0] + balanced.targets[1]));
}

TEST_CASE("weights: centroids and energies are those of the weighted cells, at distances without weights") {
  const Mesh mesh = test::make_grid(8, 6);
  const std::vector<SurfacePoint> generators = test::random_generators(mesh, 7, 4);
  DiagramOptions options;
  options.weights = random_weights(mesh, generators, 0.9, 4);
  const Diagram diagram = test::compute_sound(mesh, generators, options);
  const auto moments = compute_cell_moments(mesh, diagram);
  // On a flat mesh the logarithm is the vector from the generator, but for a rotation.
  IdVector<GeneratorId, Vec3> sum(generators.size(), Vec3::Zero());
  IdVector<GeneratorId, double> energy(generators.size(), 0.0);
  const auto add = [&](FaceId f, GeneratorId g, const std::array<Bary, 3>& corners) {
    std::array<Vec3, 3> p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = position(mesh, {f, corners[i]}) - position(mesh, generators[g.index()]);
    const double area = 0.5 * (p[1] - p[0]).cross(p[2] - p[0]).z();
    sum[g] += area * (p[0] + p[1] + p[2]) / 3;
    energy[g] += area * ((p[0] + p[1]).squaredNorm() + (p[1] + p[2]).squaredNorm() + (p[2] + p[0]).squaredNorm()) / 12;
  };
  for (const FaceId f : mesh.faces()) {
    if (diagram.face_label[f].valid()) add(f, diagram.face_label[f], kWholeTriangle);
  }
  for (const FacePiece& piece : diagram.pieces) {
    for (std::size_t k = 1; k + 1 < piece.corners.size(); ++k) {
      add(piece.face, piece.generator, {piece.corners[0], piece.corners[k], piece.corners[k + 1]});
    }
  }
  for (const GeneratorId g : moments.ids()) {
    CHECK(moments[g].area == Approx(diagram.cells[g].area));
    CHECK(moments[g].centroid.norm() == Approx(sum[g].norm() / moments[g].area).epsilon(1e-8));
    CHECK(moments[g].energy == Approx(energy[g]).epsilon(1e-8));
  }
}

TEST_CASE("balance: in turns with moves, generators come to the centroids of equal cells") {
  const Mesh mesh = test::make_sphere(4);
  const std::vector<SurfacePoint> generators = test::sample(mesh, Sampling::farthest, 12);
  BalancedRelaxationOptions options;
  options.max_rounds = 0;
  const BalancedRelaxation before = relax_balanced(mesh, generators, options);
  CHECK(before.balanced.diagram.generators == generators);
  options.max_rounds = 10;
  options.freedom.assign(generators.size(), Freedom::free);
  options.freedom[3] = Freedom::fixed;
  const BalancedRelaxation after = relax_balanced(mesh, generators, options);
  CHECK(after.rounds > 0);
  CHECK(after.residual < 0.1 * before.residual);
  CHECK(after.balanced.converged);
  CHECK(coefficient_of_variation(after.balanced.masses) <= 1e-6);
  CHECK(after.balanced.diagram.generators[3] == generators[3]);
  options.max_rounds = -1;
  CHECK(refusal([&] { relax_balanced(mesh, generators, options); }) == "the number of rounds must not be negative");
}

TEST_CASE("balance: no bit depends on the number of threads") {
  const Mesh mesh = test::make_bumpy_sphere(4, 5);
  const std::vector<SurfacePoint> generators = test::random_generators(mesh, 20, 5);
  BalanceOptions options;
  options.diagram.threads = 1;
  const BalancedDiagram one = balance_cells(mesh, generators, options);
  options.diagram.threads = 3;
  const BalancedDiagram three = balance_cells(mesh, generators, options);
  CHECK(one.masses == three.masses);
  CHECK(one.diagram.weights == three.diagram.weights);
  CHECK(test::same_diagram(one.diagram, three.diagram));
}

TEST_CASE("balance: options out of their range are refused in one line") {
  const Mesh mesh = test::make_sphere(2);
  const std::vector<SurfacePoint> generators = test::sample(mesh, Sampling::farthest, 3);
  const auto message = [&](const BalanceOptions& options) {
    return refusal([&] { balance_cells(mesh, generators, options); });
  };
  CHECK(message({.shares = {1, 2}}) == "there are 2 shares for 3 generators; give one for each");
  CHECK(message({.shares = {1, 0, 2}}) == "share 1 is 0; give finite numbers above 0");
  CHECK(message({.tolerance = std::nan("")}) == "the tolerance of balancing must be above 0");
  CHECK(message({.max_diagrams = 0}) == "balancing needs at least one diagram");
  BalanceOptions other;
  other.diagram.method = Method::gbgvd;
  CHECK(message(other) == "weights need the exact method; choose it, or leave them out");
}

TEST_CASE("balance: cells inside regions have equal shares of their own region's area") {
  const Mesh mesh = test::make_grid(10, 4);
  FaceRegions regions;
  std::vector<double> area(3, 0.0), count(3, 0.0);
  for (const FaceId f : mesh.faces()) {
    const double x = position(mesh, make_surface_point(f, {1 / 3.0, 1 / 3.0, 1 / 3.0})).x();
    area[std::size_t(regions[regions.push_back(x < 5 ? 0 : x < 8 ? 1 : 2)])] += mesh.area(f);
  }
  const SeparatedMesh apart = separate_regions(mesh, regions);
  RegionSamplingOptions options;
  options.sampling.count = 20;
  const std::vector<SurfacePoint> points = sample_regions(apart, regions, options).points;
  for (const SurfacePoint& p : points) ++count[std::size_t(regions[p.face])];
  const BalancedDiagram balanced = balance_cells(apart.mesh, points);
  REQUIRE(balanced.converged);
  CHECK(check_diagram(apart.mesh, balanced.diagram).violations.empty());
  const CutMesh cut = cut_faces(mesh, balanced.diagram);
  std::vector<double> areas(points.size(), 0.0);
  for (const FaceId f : cut.mesh.faces()) areas[cut.label[f].index()] += cut.mesh.area(f);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto region = std::size_t(regions[points[i].face]);
    CHECK(balanced.targets[i] == Approx(area[region] / count[region]).epsilon(1e-9));
    CHECK(areas[i] == Approx(balanced.masses[i]).epsilon(1e-9));
  }
}

}  // namespace gvd::test_balance
