// Whole diagrams against what is known without them: a planar Voronoi diagram, the analytic sphere, exact distances.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "gvd/diagram.hpp"
#include "gvd/verify.hpp"
#include "support/brute_force.hpp"
#include "support/catch.hpp"
#include "support/exact_fields.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/models.hpp"
#include "support/planar_voronoi.hpp"
#include "support/random.hpp"
#include "support/sound_diagram.hpp"
#include "support/stages.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_diagram_oracle {

using test::compute_sound;

constexpr int kWidth = 24, kHeight = 18;

Vec2 flat(const Vec3& p) { return p.head<2>(); }

/// The branch point of these generators that is nearest to p; infinite where there is none.
double distance_to_branch(const Diagram& diagram, const Vec2& p, const std::vector<int>& generators) {
  double least = std::numeric_limits<double>::infinity();
  for (const BranchPoint& b : diagram.branch_points) {
    std::vector<int> own;
    for (const GeneratorId g : b.generators) own.push_back(g.value());
    std::sort(own.begin(), own.end());
    if (own == generators) least = std::min(least, (flat(b.position) - p).norm());
  }
  return least;
}

double wrong_share(const test::DistanceFields& fields, const Diagram& diagram) {
  return double(test::find_wrong_labels(fields, diagram.vertex_label).size()) / double(diagram.vertex_label.size());
}

/// Largest differences between a diagram of a flat mesh and the planar Voronoi diagram, in edges. With circular fronts
/// the distances of a generator are exact in its cell. The domination test stops it a little beyond, where its last
/// distances may be those along edges. Each tolerance is about twice the maximum over 80 diagrams of the 24 x 18 grid.
struct FlatTolerance {
  double distance, label, area, branch_point, error_mean;
};
constexpr FlatTolerance kCircle{0.15, 0.15, 1.0, 1.0, 0.015}, kPlanar{1.5, 1.2, 12, 6, 0.4};

void require_near_planar(const Mesh& mesh, const std::vector<SurfacePoint>& generators, Front front,
                         const FlatTolerance& tolerance) {
  const Diagram diagram = compute_sound(mesh, generators, front);
  std::vector<Vec2> points;
  for (const SurfacePoint& g : generators) points.push_back(flat(position(mesh, g)));
  const test::PlanarVoronoi voronoi(points, kWidth, kHeight);
  for (int i = 0; i < mesh.vertex_count(); ++i) {
    const Vec2 p = flat(mesh.position(VertexId(i)));
    const double nearest = voronoi.nearest_distance(p);
    REQUIRE(diagram.vertex_distance[VertexId(i)] >= nearest - 1e-7);  // a path's length, and a symbolic offset
    REQUIRE(diagram.vertex_distance[VertexId(i)] <= nearest + tolerance.distance);
    REQUIRE((points[diagram.vertex_label[VertexId(i)].index()] - p).norm() <= nearest + tolerance.label);
  }
  for (const auto& corner : voronoi.corners()) {
    // Where a fourth generator is almost as near, the branch point may be one of its own.
    if (voronoi.lead(corner) < tolerance.branch_point) continue;
    CHECK(distance_to_branch(diagram, corner.point, corner.generators) < tolerance.branch_point);
  }
  for (const Cell& cell : diagram.cells) {
    CHECK(cell.area == Approx(voronoi.cell_area(cell.generator.value())).margin(tolerance.area).epsilon(0));
  }
  CHECK(verify_diagram(mesh, diagram).error_mean < tolerance.error_mean);
}

TEST_CASE("the diagram of a flat mesh comes near to the planar Voronoi diagram, branch points included") {
  for (const bool jittered : {false, true}) {
    const Mesh mesh = jittered ? test::make_jittered_grid(kWidth, kHeight, 0.2, 1) : test::make_grid(kWidth, kHeight);
    for (unsigned seed = 0; seed < 8; ++seed) {
      INFO("seed " << seed << (jittered ? ", jittered" : ""));
      const auto generators = test::random_generators(mesh, 14, seed);
      require_near_planar(mesh, generators, Front::circle, kCircle);
      require_near_planar(mesh, generators, Front::planar, kPlanar);
    }
  }
}

TEST_CASE("with circles three generators in general position have their circumcentre as branch point") {
  // Few cells, all wide: the march goes well beyond them, and everything is exact but for the symbolic offsets.
  constexpr double kExact = 1e-6;
  const Mesh mesh = test::make_grid(kWidth, kHeight);
  const auto at = [](int i, int j) { return j * (kWidth + 1) + i; };
  for (const std::vector<int>& ids :
       {std::vector<int>{at(4, 4), at(20, 4), at(12, 14)}, {at(2, 3), at(18, 2), at(11, 15)}}) {
    const Diagram diagram = compute_sound(mesh, test::at_vertices(mesh, ids), Front::circle);
    std::vector<Vec2> points;
    for (const int id : ids) points.push_back(flat(mesh.position(VertexId(id))));
    const auto corners = test::PlanarVoronoi(points, kWidth, kHeight).corners();
    REQUIRE(corners.size() == 1);
    REQUIRE(diagram.branch_points.size() == 1);
    CHECK(distance_to_branch(diagram, corners.front().point, corners.front().generators) < kExact);
    CHECK(diagram.branch_points[BranchPointId(0)].distance ==
          Approx((points.front() - corners.front().point).norm()).margin(kExact));
  }
}

TEST_CASE("on a sphere the cells are those of great-circle distances") {
  constexpr int kSamples = 40000;
  const Mesh mesh = test::make_sphere(4);
  for (unsigned seed = 0; seed < 3; ++seed) {
    INFO("seed " << seed);
    const auto generators = test::random_generators(mesh, 15, seed);
    const Diagram diagram = compute_sound(mesh, generators, Front::circle);
    std::vector<Vec3> poles;
    for (const SurfacePoint& g : generators) poles.push_back(position(mesh, g).normalized());
    const auto great_circle = [](const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); };
    for (int i = 0; i < mesh.vertex_count(); ++i) {
      const Vec3& p = mesh.position(VertexId(i));
      double nearest = 4;
      for (const Vec3& pole : poles) nearest = std::min(nearest, great_circle(p, pole));
      // Chords are shorter than arcs by 0.05 % at this resolution, and fast marching adds a little.
      REQUIRE(great_circle(p, poles[diagram.vertex_label[VertexId(i)].index()]) <= nearest * 1.01 + 1e-9);
      REQUIRE(diagram.vertex_distance[VertexId(i)] == Approx(nearest).epsilon(0.01));
    }
    test::Random random(seed);
    std::vector<int> hits(poles.size(), 0);
    for (int i = 0; i < kSamples; ++i) {
      const double z = random.real(-1, 1), angle = random.real(0, 2 * std::numbers::pi), r = std::sqrt(1 - z * z);
      const Vec3 p(r * std::cos(angle), r * std::sin(angle), z);
      const auto nearer = [&](const Vec3& a, const Vec3& b) { return a.dot(p) > b.dot(p); };
      ++hits[std::min_element(poles.begin(), poles.end(), nearer) - poles.begin()];
    }
    for (const Cell& cell : diagram.cells) {
      const double share = double(hits[cell.generator.index()]) / kSamples;
      const double deviation = std::sqrt(share * (1 - share) / kSamples);
      CHECK(std::abs(cell.area / (4 * std::numbers::pi) - share) < 0.02 * share + 4 * deviation);
    }
  }
}

TEST_CASE("few labels differ from the brute force by exact distances, and by little, on every family") {
  for (const auto& [name, mesh] : test::small_family()) {
    const auto generators = test::random_generators(mesh, 10, 20);
    const test::DistanceFields fields = test::exact_vertex_fields(mesh, generators);
    const test::Nearest nearest = test::compute_nearest(fields);
    for (const Front front : test::kFronts) {
      INFO(name << ", " << test::name(front));
      const Diagram diagram = compute_sound(mesh, generators, front);
      // Of 20 seeds the worst: 2.1 % wrong and 0.33 edges too far with circles; 17 % and 1.8 edges with planar fronts.
      CHECK(wrong_share(fields, diagram) <= (front == Front::circle ? 0.03 : 0.2));
      for (int v = 0; v < mesh.vertex_count(); ++v) {
        const GeneratorId label = diagram.vertex_label[VertexId(v)];
        REQUIRE(label.valid() == nearest.label[VertexId(v)].valid());
        if (!label.valid()) continue;
        const double excess = fields[label.index()][v] - nearest.distance[VertexId(v)];
        REQUIRE(excess <= (front == Front::circle ? 0.5 : 2.5) * mesh.mean_edge_length());
      }
    }
  }
}

TEST_CASE("few labels differ from those of the reference distances") {
  for (const std::string& name : test::list_references()) {
    const test::Reference reference = test::read_reference(name);
    for (const Front front : test::kFronts) {
      INFO(name << ", " << test::name(front));
      CHECK(wrong_share(reference.distances, compute_sound(reference.mesh, reference.generator_points(), front)) <=
            (front == Front::circle ? 0.01 : 0.05));
    }
  }
}

TEST_CASE("E on spot with 30 generators: the paper's figure with planar fronts, a third of it with circles") {
  const auto found = test::find_reference("spot.m30");
  if (!found) return;
  const test::Reference& spot = *found;
  const double circle =
      verify_diagram(spot.mesh, compute_sound(spot.mesh, spot.generator_points(), Front::circle)).error_integral;
  const double planar =
      verify_diagram(spot.mesh, compute_sound(spot.mesh, spot.generator_points(), Front::planar)).error_integral;
  INFO("circle " << circle << ", planar " << planar);  // 0.040 and 0.174 when this was written
  CHECK(circle <= 0.06);
  CHECK(planar <= 0.205);
  CHECK(circle < planar);
}

}  // namespace gvd::test_diagram_oracle
