// The vertex positions of a remesh: at the generators, at quadrics' minima, or fitted to the surface.
//
// A fit goes step by step, each step as far as the guard lets it: vertices at creases and on the boundary go to their
// quadric's minimum, then rounds of a least-squares fit move all of them. In a round, thin triangles are mended before
// the guard sees them, because it could only halve their steps. Edges are flipped before the last rounds, when the
// vertices are near their final positions. The mesh is valid after each step. docs/notes/remesh-placement.md has the
// measurements behind the order and the constants.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "cell_quadrics.hpp"
#include "fit_vertices.hpp"
#include "flip_edges.hpp"
#include "gvd/error.hpp"
#include "gvd/quality.hpp"
#include "move_guard.hpp"
#include "raise_angles.hpp"

namespace gvd {
namespace {

/// Eigenvalues of a quadric below this fraction of the largest one belong to directions along the surface. On a sphere,
/// a cell with an angular radius of r has the fraction r^2 / 4, so this is 0.2 radians.
constexpr double kQuadricTruncation = 0.01;
/// The number of samples of each surface for each vertex, in the last round. If there are many vertices, the rounds
/// before it use half as many, which changes the means of nine models with 2000 vertices by at most .2 %; with 100
/// vertices the RMS distance would grow by 1.3 %.
constexpr double kSamplesPerVertex = 16, kEarlySamples = 0.5, kEnoughSamples = 1 << 14;

/// The largest number of samples of a fine surface, which has one in each face, in the last round, unless the vertices
/// ask for more. The rounds before it use kEnoughSamples; in the last one, that would raise the RMS distance by 1.6 %
/// with 2000 vertices on meshes of 52,000 to 106,000 faces. With 100 and 500 vertices, 64 for each are enough to be
/// within .2 %.
constexpr double kLastSamples = 1 << 17, kLastSamplesPerVertex = 64;
/// The least area of a cell for its spring, in squares of the bounding box's diagonal, because a cell without area
/// needs a spring as well.
constexpr double kLeastCellArea = 1e-12;

/// The factor of the springs and of the price of thin triangles for a shape of 0; for a shape of 1 it is the
/// reciprocal. docs/notes/remesh-placement.md has the figures from 0 to 1.
constexpr double kLeastShapeFactor = 0.01;

/// The price of triangles with an angle below the bound of free vertices, in each round. A lower price leaves more
/// angles below 30 degrees; four times the price adds a quarter to the distance of models with creases.
constexpr double kThinPrice = 0.05;

/// The angle below which users call triangles thin, plus half a degree that the search may miss it by. In the last
/// round such triangles cost sixty times more; in all rounds, that price would move vertices off creases too early.
constexpr double kLastThinAngle = 30.5, kLastThinPrice = 3;

/// The price of Q from round kFitRounds on, times the root of the number of vertices. The square distance of a cell, in
/// units of its area, falls as 1 / n; the root lets distance and Q both gain. docs/notes/remesh-placement.md has the
/// measurements.
constexpr double kShapePrice = 0.55;
/// With fewer vertices than this, the price falls with their number, because a triangle then spans more of the surface
/// and a better shape costs more distance: with the root alone, the RMS distance of flat closed shapes with 20 vertices
/// would be up to 80 % larger.
constexpr double kFullPriceVertices = 100;

/// Fewer vertices than this get one more round, with flips and the price of Q as in the last one. With 100 vertices it
/// takes 6 % of a command's time, raises mean Q by .004 and makes the RMS distance 1 % smaller.
constexpr std::int32_t kFewVertices = 256;

double shape_factor(double shape) { return std::pow(kLeastShapeFactor, 1 - 2 * shape); }

/// The options with the bounds on angles that follow from their shape.
PlacementOptions with_bounds(PlacementOptions options) {
  const double share = std::min(1.0, 2 * options.shape);
  for (double* angle : {&options.least_angle, &options.least_crease_angle}) {
    *angle = std::lerp(std::min(*angle, kLeastPlacedAngle), *angle, share);
  }
  return options;
}

class Placer {
 public:
  Placer(const Mesh& surface, const Diagram& diagram, const Mesh& remesh, const std::vector<SurfacePoint>& face_points,
         const PlacementOptions& options)
      : surface_(surface),
        remesh_(remesh),
        generators_(diagram.generators),
        face_points_(face_points),
        options_(options),
        quadrics_(compute_cell_quadrics(surface, diagram)),
        is_held_(remesh.positions().size(), 0),
        guarded_(remesh),
        guard_(make_guard()) {
    for (std::size_t v = 0; v < is_held_.size(); ++v) is_held_[v] = is_on_boundary(surface, diagram.generators[v]);
    for (const GeneratorId g : options.fixed) is_held_[g.index()] = 1;
  }

  PlacedRemesh run(const Diagram& diagram) {
    if (options_.method == Placement::quadric) {
      guard_->loosen(std::vector<char>(is_held_.size(), 1), kLeastPlacedAngle);
      return {guard_->move(remesh_.positions(), find_optima([](std::size_t) { return true; })), {}};
    }
    SpringPlan plan{
        &remesh_, find_crease_cells(surface_, diagram, remesh_), {}, find_areas(), shape_factor(options_.shape)};
    plan.roles = find_vertex_roles(remesh_, plan.creases, is_held_);
    loosen_at_creases(plan);
    // Creases first: the samples of a round see only the triangles that are nearest to them.
    const auto starts_at_optimum = [&](std::size_t v) { return plan.roles[v] >= VertexRole::at_crease; };
    return fit(guard_->move(remesh_.positions(), find_optima(starts_at_optimum)), plan);
  }

 private:
  std::unique_ptr<MoveGuard> make_guard() const {
    return std::make_unique<MoveGuard>(surface_, guarded_, generators_, face_points_, with_bounds(options_));
  }

  void loosen_at_creases(const SpringPlan& plan) {
    guard_->loosen(list_vertices(plan, VertexRole::at_crease), with_bounds(options_).least_crease_angle);
  }

  template <class Takes>
  std::vector<Vec3> find_optima(const Takes& takes) const {
    std::vector<Vec3> optima = remesh_.positions();
    for (const GeneratorId g : quadrics_.ids()) {
      if (takes(g.index())) optima[g.index()] += quadrics_[g].minimize(kQuadricTruncation);
    }
    keep_fixed(optima);
    return optima;
  }

  void keep_fixed(std::vector<Vec3>& positions) const {
    for (const GeneratorId g : options_.fixed) positions[g.index()] = remesh_.position(VertexId(g.value()));
  }

  PlacedRemesh fit(std::vector<Vec3> positions, const SpringPlan& plan) {
    std::vector<EdgeFlip> flips;
    const int rounds = kFitRounds + (remesh_.vertex_count() < kFewVertices ? 1 : 0);
    const ClosestPointTree tree(surface_);
    FitTarget target{&surface_, &tree, {}, 0, options_.threads, options_.progress};
    for (int round = 0; round < rounds; ++round) {
      const bool is_late = round + 1 >= kFitRounds;
      if (round == 0 || round + 1 == kFitRounds) sample(target, is_late);
      report_progress(options_.progress, "placement", double(round) / rounds);
      if (is_late) flip(positions, plan, tree, flips);
      const Mesh current = with_positions(guarded_, positions);
      const FaceSystems systems = find_face_systems(current, target);
      std::vector<Vec3> fitted = fit_vertices(current, systems, make_springs(current, plan), options_.progress);
      keep_fixed(fitted);
      const AngleSearch search{&current, &systems, guard_.get(), &plan, options_.progress};
      positions = guard_->move(positions, improve_triangles(search, plan.stiffness, is_late, std::move(fitted)));
    }
    return {std::move(positions), std::move(flips)};
  }

  /// Flips edges and adds them to `flips`. The guard judges the moves that follow by the resulting mesh.
  void flip(const std::vector<Vec3>& positions, const SpringPlan& plan, const ClosestPointTree& tree,
            std::vector<EdgeFlip>& flips) {
    std::vector<char> on_curve(positions.size(), 0);
    for (const GeneratorId g : options_.on_curves) on_curve[g.index()] = 1;
    for (const GeneratorId g : plan.creases.ids()) on_curve[g.index()] |= plan.creases[g].is_met;
    const std::vector<Vec3> at_generators = normals_at(generators_), at_faces = normals_at(face_points_);
    const FlipSearch search{&surface_,
                            &tree,
                            &at_generators,
                            &at_faces,
                            &plan,
                            &on_curve,
                            plan.stiffness * shape_price(),
                            options_.threads,
                            options_.progress};
    const std::vector<EdgeFlip> found = flip_edges(search, with_positions(guarded_, positions));
    if (found.empty()) return;
    flips.insert(flips.end(), found.begin(), found.end());
    guarded_ = Mesh(positions, apply_flips(guarded_.face_vertices(), found));
    guard_ = make_guard();
    loosen_at_creases(plan);
  }

  std::vector<Vec3> normals_at(const std::vector<SurfacePoint>& points) const {
    std::vector<Vec3> normals;
    for (const SurfacePoint& p : points) normals.push_back(surface_normal(surface_, p));
    return normals;
  }

  double shape_price() const {
    const double vertices = remesh_.vertex_count(), full = std::max(kFullPriceVertices, vertices);
    return kShapePrice / std::sqrt(full) * vertices / full;
  }

  void sample(FitTarget& target, bool is_late) const {
    const double vertices = remesh_.vertex_count();
    const double all = kSamplesPerVertex * vertices;
    target.count = is_late ? all : std::min(all, std::max(kEnoughSamples, kEarlySamples * all));
    const double last = std::clamp(kLastSamplesPerVertex * vertices, kEnoughSamples, kLastSamples);
    target.samples = thin_out(sample_surface(surface_, target.count), std::max(is_late ? last : kEnoughSamples, all));
  }

  std::vector<Vec3> improve_triangles(const AngleSearch& search, double stiffness, bool is_late,
                                      std::vector<Vec3> positions) const {
    const double shape = is_late ? shape_price() : 0;
    const auto raise = [&](double angle, double price) {
      positions = raise_angles(search, {angle, stiffness * price, stiffness * shape}, std::move(positions));
    };
    raise(options_.least_angle, kThinPrice);
    if (is_late) raise(kLastThinAngle, kLastThinPrice);
    return positions;
  }

  std::vector<double> find_areas() const {
    const double least = kLeastCellArea * surface_.bbox_diagonal() * surface_.bbox_diagonal();
    std::vector<double> areas;
    for (const Quadric& quadric : quadrics_) areas.push_back(std::max(quadric.area, least));
    return areas;
  }

  static std::vector<char> list_vertices(const SpringPlan& plan, VertexRole role) {
    std::vector<char> chosen;
    for (const VertexRole r : plan.roles) chosen.push_back(r == role);
    return chosen;
  }

  const Mesh& surface_;
  const Mesh& remesh_;
  const std::vector<SurfacePoint>& generators_;
  const std::vector<SurfacePoint>& face_points_;
  const PlacementOptions& options_;
  IdVector<GeneratorId, Quadric> quadrics_;
  std::vector<char> is_held_;  // at the boundary, or fixed
  Mesh guarded_;               // that the guard judges by: of the last flips
  std::unique_ptr<MoveGuard> guard_;
};

}  // namespace

void check_placement(const PlacementOptions& options, std::size_t generators) {
  if (!(options.shape >= 0 && options.shape <= 1)) {
    throw Error(ErrorCode::invalid_option, "the shape must be from 0 to 1");
  }
  for (const double angle : {options.least_angle, options.least_crease_angle}) {
    if (!(angle >= 0 && angle <= 60)) {
      throw Error(ErrorCode::invalid_option, "the least angles must be from 0 to 60 degrees");
    }
  }
  for (const auto& [list, what] : {std::pair(&options.fixed, "fixed"), std::pair(&options.on_curves, "curves'")}) {
    for (const GeneratorId g : *list) {
      if (g.valid() && g.index() < generators) continue;
      throw Error(ErrorCode::invalid_option, fmt::format("a {} generator is none of the remesh", what), g.value());
    }
  }
}

PlacedRemesh place_vertices(const Mesh& surface, const Diagram& diagram, const Mesh& remesh,
                            const std::vector<SurfacePoint>& face_points, const PlacementOptions& options) {
  if (remesh.vertex_count() != std::ssize(diagram.generators) || remesh.face_count() != std::ssize(face_points)) {
    throw Error(ErrorCode::precondition, "the remesh is not the dual of the diagram");
  }
  check_placement(options, diagram.generators.size());
  if (options.method == Placement::generator) return {remesh.positions(), {}};
  return Placer(surface, diagram, remesh, face_points, options).run(diagram);
}

}  // namespace gvd
