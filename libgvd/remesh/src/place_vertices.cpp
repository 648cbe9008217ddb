// The vertex positions of a remesh: at the generators, at quadrics' minima, or fitted to the surface.
//
// A fit goes step by step, each step as far as the guard lets it: vertices at creases and on the boundary go to their
// quadric's minimum, rounds of a least-squares fit move all of them, and at last the smallest angles are raised. The
// positions are valid after each step, so that a step may be left out. docs/notes/remesh-placement.md has the
// measurements behind the order and the constants.
//
// No triangle may flip, get an angle below its bound, or intersect one that it did not intersect at the generators. The
// guard halves the steps of all vertices of wrong triangles until none is wrong. Intersections are looked for only
// where the triangles are valid one by one: that test costs most. A triangle that was wrong at the generators is not
// judged.
// Source of the raised angles: optimisation-based smoothing (L. Freitag and C. Ollivier-Gooch, Tetrahedral mesh
// improvement using swapping and smoothing, 1997), with a search in place of the linear programs.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "dual/dual_steps.hpp"
#include "gvd/error.hpp"
#include "gvd/quality.hpp"
#include "placement_steps.hpp"

namespace gvd {
namespace {

/// Fraction of an angle by which it may shrink even where it is below the bound: a million times the rounding.
constexpr double kAngleSlack = 1e-9;

/// Directions in which a vertex tries to move.
constexpr int kDirections = 8;

/// Length of the first steps, relative to the mean edge of the vertex; the next ones are half as long.
constexpr double kFirstStep = 0.2;

/// Gains of less than this, in degrees, are none: a million times the rounding.
constexpr double kLeastGain = 1e-6;

class AngleRaiser {
 public:
  AngleRaiser(const Mesh& mesh, double least_angle)
      : least_angle_(least_angle),
        positions_(mesh.positions()),
        placed_(mesh, positions_),
        faces_of_(positions_.size()) {
    for (const FaceId f : mesh.faces()) {
      for (const VertexId v : mesh.vertices(f)) faces_of_[v.index()].push_back(f);
    }
  }

  /// Passes over the vertices once. False if none has moved.
  bool pass(const std::vector<char>& movable, const Progress& progress) {
    bool has_moved = false;
    for (std::size_t v = 0; v < positions_.size(); ++v) {
      report_progress(progress, "placement", double(v) / double(positions_.size()));
      if (movable[v] && smallest_angle(v) < least_angle_) has_moved |= improve(v);
    }
    return has_moved;
  }

  const std::vector<Vec3>& positions() const { return positions_; }

 private:
  std::vector<double> angles(std::size_t v) const {
    std::vector<double> all;
    for (const FaceId f : faces_of_[v]) {
      const auto [a, b, c] = placed_.corners(f);
      all.push_back(compute_min_angle(a, b, c));
    }
    return all;
  }

  double smallest_angle(std::size_t v) const {
    const std::vector<double> all = angles(v);
    return *std::min_element(all.begin(), all.end());
  }

  /// Whether a triangle gets thinner than it was and than the bound.
  bool thins_another(std::size_t v, double smallest, const std::vector<double>& before) const {
    if (smallest >= least_angle_) return false;
    const std::vector<double> now = angles(v);
    for (std::size_t i = 0; i < now.size(); ++i) {
      if (now[i] < std::min(before[i], least_angle_)) return true;
    }
    return false;
  }

  /// Two directions along the surface at a vertex, with the length of its faces' mean edge.
  std::array<Vec3, 2> axes(std::size_t v) const {
    Vec3 normal(0, 0, 0);
    double length = 0;
    for (const FaceId f : faces_of_[v]) {
      const auto [a, b, c] = placed_.corners(f);
      normal += (b - a).cross(c - a);
      length += ((b - a).norm() + (c - b).norm() + (a - c).norm()) / 3;
    }
    length /= double(faces_of_[v].size());
    const Vec3 first = normal.unitOrthogonal();
    return {length * first, length * normal.normalized().cross(first)};
  }

  /// Tries places round the vertex, with steps that get shorter, and keeps the best. False if the vertex stays.
  bool improve(std::size_t v) {
    const auto [x, y] = axes(v);
    Vec3 best = positions_[v];
    double best_angle = smallest_angle(v);
    const std::vector<double> before = angles(v);
    bool has_moved = false;
    double step = kFirstStep;
    for (int trial = 0; trial < kAngleTrials; trial += kDirections, step /= 2) {
      const Vec3 from = best;
      for (int k = 0; k < kDirections; ++k) {
        const double turn = 2 * std::numbers::pi * k / kDirections;
        positions_[v] = from + step * (std::cos(turn) * x + std::sin(turn) * y);
        const double angle = smallest_angle(v);
        if (!(angle > best_angle + kLeastGain) || thins_another(v, angle, before)) continue;
        best = positions_[v];
        best_angle = angle;
        has_moved = true;
      }
    }
    positions_[v] = best;
    return has_moved;
  }

  double least_angle_;
  std::vector<Vec3> positions_;
  PlacedFaces placed_;
  std::vector<std::vector<FaceId>> faces_of_;
};

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
    return guard_.move(positions, raise_least_angles(fitted, movable, options_.least_angle, options_.progress));
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
    const FitTarget target{&surface_,        &tree, sample_surface(surface_, count), count, options_.threads,
                           options_.progress};
    for (int round = 0; round < kFitRounds; ++round) {
      report_progress(options_.progress, "placement", double(round) / kFitRounds);
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

Mesh with_positions(const Mesh& mesh, std::vector<Vec3> positions) {
  return {std::move(positions), mesh.face_vertices()};
}

std::vector<Vec3> raise_least_angles(const Mesh& mesh, const std::vector<char>& movable, double least_angle,
                                     const Progress& progress) {
  AngleRaiser raiser(mesh, least_angle);
  for (int pass = 0; pass < kAnglePasses && raiser.pass(movable, progress); ++pass) {
  }
  return raiser.positions();
}

MoveGuard::MoveGuard(const Mesh& surface, const Mesh& remesh, const std::vector<SurfacePoint>& generators,
                     const std::vector<SurfacePoint>& face_points, const PlacementOptions& options)
    : remesh_(remesh),
      threads_(options.threads),
      progress_(options.progress),
      crossed_before_(find_self_intersections(remesh, threads_, progress_)) {
  normal_ = IdVector<FaceId, Vec3>(normals_at_faces(surface, remesh, generators, face_points));
  for (const FaceId f : remesh.faces()) {
    const auto& [a, b, c] = PlacedFaces(remesh).corners(f);
    // Rounding must not take a triangle that does not move for one that is worse than before.
    least_angle_.push_back(std::min(options.least_angle, (1 - kAngleSlack) * compute_min_angle(a, b, c)));
  }
}

void MoveGuard::loosen(const std::vector<char>& vertices, double least_angle) {
  for (const FaceId f : remesh_.faces()) {
    const auto& [a, b, c] = remesh_.vertices(f);
    if (!vertices[a.index()] && !vertices[b.index()] && !vertices[c.index()]) continue;
    least_angle_[f] = std::min(least_angle_[f], least_angle);
  }
}

bool MoveGuard::is_bad(FaceId f, const std::vector<Vec3>& positions) const {
  const Triangle triangle = PlacedFaces(remesh_, positions).corners(f);
  return is_flipped(triangle, normal_[f]) || compute_min_angle(triangle[0], triangle[1], triangle[2]) < least_angle_[f];
}

std::vector<FaceId> MoveGuard::find_bad_faces(const std::vector<Vec3>& positions) const {
  std::vector<FaceId> bad;
  for (const FaceId f : remesh_.faces()) {
    if (is_bad(f, positions) && !is_bad(f, remesh_.positions())) bad.push_back(f);
  }
  return bad;
}

std::vector<FaceId> MoveGuard::find_crossed_faces(const std::vector<Vec3>& positions) const {
  std::vector<FaceId> crossed;
  for (const FacePair& pair : find_self_intersections({remesh_, positions}, threads_, progress_)) {
    if (std::binary_search(crossed_before_.begin(), crossed_before_.end(), pair)) continue;
    crossed.insert(crossed.end(), {pair.first, pair.second});
  }
  return crossed;
}

std::vector<Vec3> MoveGuard::move(const std::vector<Vec3>& from, const std::vector<Vec3>& to) const {
  std::vector<int> halvings(from.size(), 0);
  std::vector<Vec3> positions = to;
  while (true) {
    report_progress(progress_, "placement", 1);
    std::vector<FaceId> wrong = find_bad_faces(positions);
    if (wrong.empty()) wrong = find_crossed_faces(positions);
    if (wrong.empty()) return positions;
    std::vector<char> halve(from.size(), 0);
    for (const FaceId f : wrong) {
      for (const VertexId v : remesh_.vertices(f)) halve[v.index()] = 1;
    }
    for (std::size_t v = 0; v < from.size(); ++v) {
      if (!halve[v]) continue;
      ++halvings[v];
      positions[v] = halvings[v] > kMaxHalvings ? from[v] : Vec3((positions[v] + from[v]) / 2);
    }
  }
}

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
