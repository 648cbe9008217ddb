// The vertex positions of a remesh: at the generators, at quadrics' minima, or fitted to the surface.
//
// A fit goes step by step, each step as far as the guard lets it: vertices at creases and on the boundary go to their
// quadric's minimum, rounds of a least-squares fit move all of them, and at last the smallest angles are raised. The
// positions are valid after each step, so that a step may be left out. docs/notes/remesh-placement.md has the
// measurements behind the order and the constants.

#include <algorithm>
#include <utility>

#include "gvd/error.hpp"
#include "placement_steps.hpp"

namespace gvd {
namespace {

/// Eigenvalues of a quadric below this fraction of the largest one are those of directions along the surface. The cell
/// of a sphere with an angular radius of r has r^2 / 4: 0.2 radians.
constexpr double kQuadricTruncation = 0.01;
/// Samples of each surface for each vertex.
constexpr double kSamplesPerVertex = 16;
/// Least area of a cell for its spring, in squares of the bounding box's diagonal: a cell of no area needs one, too.
constexpr double kLeastCellArea = 1e-12;

class Placer {
 public:
  Placer(const Mesh& surface, const Diagram& diagram, const Mesh& remesh, const std::vector<SurfacePoint>& face_points,
         const PlacementOptions& options)
      : surface_(surface),
        remesh_(remesh),
        options_(options),
        quadrics_(compute_cell_quadrics(surface, diagram)),
        is_held_(remesh.positions().size(), 0),
        guard_(surface, remesh, diagram.generators, face_points, options) {
    for (std::size_t v = 0; v < is_held_.size(); ++v) is_held_[v] = is_on_boundary(surface, diagram.generators[v]);
    for (const GeneratorId g : options.fixed) is_held_[g.index()] = 1;
  }

  std::vector<Vec3> run(const Diagram& diagram) {
    if (options_.method == Placement::quadric) {
      guard_.loosen(std::vector<char>(is_held_.size(), 1), options_.least_crease_angle);
      return guard_.move(remesh_.positions(), find_optima([](std::size_t) { return true; }));
    }
    SpringPlan plan{&remesh_, find_crease_cells(surface_, diagram, remesh_), {}, find_areas()};
    plan.roles = find_vertex_roles(remesh_, plan.creases, is_held_);
    guard_.loosen(list_vertices(plan, VertexRole::at_crease), options_.least_crease_angle);
    // Creases first: the samples of a round see only the triangles that are nearest to them.
    const auto starts_at_optimum = [&](std::size_t v) { return plan.roles[v] >= VertexRole::at_crease; };
    std::vector<Vec3> positions = guard_.move(remesh_.positions(), find_optima(starts_at_optimum));
    positions = fit(std::move(positions), plan);
    const Mesh fitted = with_positions(remesh_, positions);
    const auto movable = list_vertices(plan, VertexRole::free);
    return guard_.move(positions, raise_least_angles(fitted, movable, options_.least_angle));
  }

 private:
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

  std::vector<Vec3> fit(std::vector<Vec3> positions, const SpringPlan& plan) const {
    const ClosestPointTree tree(surface_);
    const double count = kSamplesPerVertex * remesh_.vertex_count();
    const FitTarget target{&surface_, &tree, sample_surface(surface_, count), count, options_.threads};
    for (int round = 0; round < kFitRounds; ++round) {
      const Mesh current = with_positions(remesh_, positions);
      std::vector<Vec3> fitted = fit_vertices(current, target, make_springs(current, plan));
      keep_fixed(fitted);
      positions = guard_.move(positions, fitted);
    }
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
  const PlacementOptions& options_;
  IdVector<GeneratorId, Quadric> quadrics_;
  std::vector<char> is_held_;  // at the boundary, or fixed
  MoveGuard guard_;
};

}  // namespace

void check_placement(const PlacementOptions& options, std::size_t generators) {
  for (const double angle : {options.least_angle, options.least_crease_angle}) {
    if (!(angle >= 0 && angle <= 60)) {
      throw Error(ErrorCode::invalid_option, "the least angles must be from 0 to 60 degrees");
    }
  }
  for (const GeneratorId g : options.fixed) {
    if (!g.valid() || g.index() >= generators) {
      throw Error(ErrorCode::invalid_option, "a fixed generator is none of the remesh", g.value());
    }
  }
}

std::vector<Vec3> place_vertices(const Mesh& surface, const Diagram& diagram, const Mesh& remesh,
                                 const std::vector<SurfacePoint>& face_points, const PlacementOptions& options) {
  if (remesh.vertex_count() != std::ssize(diagram.generators) || remesh.face_count() != std::ssize(face_points)) {
    throw Error(ErrorCode::precondition, "the remesh is not the dual of the diagram");
  }
  check_placement(options, diagram.generators.size());
  if (options.method == Placement::generator) return remesh.positions();
  return Placer(surface, diagram, remesh, face_points, options).run(diagram);
}

}  // namespace gvd
