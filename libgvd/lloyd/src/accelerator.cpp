// Better steps than Lloyd's, by L-BFGS with the Hessian of the energy or by Anderson's mixing.
//
// L-BFGS begins with an approximate Hessian: exact in the plane, and on surfaces in the limit of small cells. Its
// inverse comes from a Lanczos process on the matrix relative to the masses, with the absolute values of its
// eigenvalues, so that every step lowers the energy if it is short enough. Sources are with EnergyHessian and in
// optimiser.hpp. Generators at vertices take no part: there the gradient jumps, and they take Lloyd's step or rest.
#include "accelerator.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "gvd/geodesic_tracing.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {
namespace {

/// Least absolute eigenvalue relative to the masses: no step is more than ten times as long as Lloyd's by the Hessian
/// alone. With 0.05, 0.2 and 0.3 runs on the bunny take as many iterations or more.
constexpr double kLeastEigenvalue = 0.1;

/// Steps of the Lanczos process. With 40 runs do not take fewer iterations.
constexpr int kLanczosSteps = 20;

/// Distance of the points of Gauss' quadrature from the middle of an interval of length 1: 1 / sqrt(12).
constexpr double kGaussPoint = 0.28867513459481287;

/// The tangent plane at a point, in space.
struct TangentFrame {
  Vec3 origin, x, y;

  Vec2 project(const Vec3& p) const { return {(p - origin).dot(x), (p - origin).dot(y)}; }
};

TangentFrame make_frame(const Mesh& mesh, const SurfacePoint& point) {
  HalfedgeId h = Mesh::halfedge(point.face, 0);
  if (point.kind() == SurfacePoint::Kind::edge) h = halfedge(point);
  if (point.kind() == SurfacePoint::Kind::vertex) h = mesh.halfedge(vertex(mesh, point));
  const Vec3 normal = surface_normal(mesh, point), along = mesh.position(mesh.to(h)) - mesh.position(mesh.from(h));
  const Vec3 x = (along - along.dot(normal) * normal).normalized();
  return {position(mesh, point), x, normal.cross(x)};
}

/// The integral over a segment, by the two points of Gauss: exact for the quadratic integrand.
Eigen::Matrix4d integrate(const BisectorSegment& segment, const TangentFrame& left, const TangentFrame& right) {
  Eigen::Matrix4d form = Eigen::Matrix4d::Zero();
  const double between = (left.origin - right.origin).norm();
  if (!(between > 0)) return form;
  for (const double share : {0.5 - kGaussPoint, 0.5 + kGaussPoint}) {
    const Vec3 at = segment.from + share * (segment.to - segment.from);
    Eigen::Vector4d v;
    v << left.project(at), -right.project(at);
    form += segment.density * segment.length / between * v * v.transpose();
  }
  return form;
}

/// Each vector divided by the root of its mass.
TangentField divided_by_roots(TangentField field, const std::vector<double>& masses) {
  for (std::size_t i = 0; i < field.size(); ++i) field[i] /= std::sqrt(masses[i]);
  return field;
}

}  // namespace

EnergyHessian::EnergyHessian(const Mesh& mesh, const RelaxationState& state) : masses_(cell_masses(state)) {
  std::vector<TangentFrame> frames;
  for (const SurfacePoint& p : state.generators) frames.push_back(make_frame(mesh, p));
  for (const BisectorSegment& segment : state.segments) {
    const std::size_t left = segment.left.index(), right = segment.right.index();
    if (couplings_.empty() || couplings_.back().left != left || couplings_.back().right != right) {
      couplings_.push_back({left, right, Eigen::Matrix4d::Zero()});
    }
    couplings_.back().form += integrate(segment, frames[left], frames[right]);
  }
}

TangentField EnergyHessian::multiply_couplings(const TangentField& field) const {
  TangentField product(field.size(), Vec2::Zero());
  for (const Coupling& c : couplings_) {
    Eigen::Vector4d both;
    both << field[c.left], field[c.right];
    const Eigen::Vector4d part = c.form * both;
    product[c.left] += part.head<2>();
    product[c.right] += part.tail<2>();
  }
  return product;
}

TangentField EnergyHessian::multiply(const TangentField& field) const {
  TangentField product = multiply_couplings(field);
  for (std::size_t i = 0; i < field.size(); ++i) product[i] = masses_[i] * field[i] - product[i];
  return product;
}

TangentField EnergyHessian::solve(const TangentField& right) const {
  const auto relative_couplings = [&](const TangentField& field) {
    return divided_by_roots(multiply_couplings(divided_by_roots(field, masses_)), masses_);
  };
  const auto inverse = [](double coupling) { return 1 / std::max(std::abs(1 - coupling), kLeastEigenvalue); };
  return divided_by_roots(
      apply_matrix_function(relative_couplings, inverse, divided_by_roots(right, masses_), kLanczosSteps), masses_);
}

namespace {

/// Pairs that are kept. With 5, 10 and 20 pairs of L-BFGS runs on the bunny take as many iterations, within 5 %.
constexpr std::size_t kLbfgsMemory = 7;
constexpr std::size_t kAndersonMemory = 6;

/// Longest step of a generator, in mean cell radii, or in ways to its centroid if that is more: beyond this the
/// neighbours of cells change.
constexpr double kLongestStep = 1;

/// Least curvature of a pair, as a fraction of that of the masses: it keeps the inverse Hessian positive definite and
/// below a hundred times Lloyd's.
constexpr double kLeastCurvature = 0.01;

bool has_curvature(const StepPair& pair, const std::vector<double>& masses) {
  double expected = 0;
  for (std::size_t i = 0; i < masses.size(); ++i) expected += masses[i] * pair.step[i].squaredNorm();
  return expected > 0 && dot(pair.step, pair.change) > kLeastCurvature * expected;
}

/// Generators that rest, or go to rest, have no step.
bool is_held(const RelaxationState& state, std::size_t i) { return state.is_resting[i] || state.rest[i]; }

/// Whether the energy is no smooth function of the generator. The steps of other generators then tell nothing about its
/// own, and it takes Lloyd's.
bool is_at_kink(const RelaxationState& state, std::size_t i) {
  return is_held(state, i) || state.generators[i].kind() == SurfacePoint::Kind::vertex;
}

}  // namespace

Accelerator::Accelerator(const Mesh& mesh, const GeneratorConstraints& constraints, Acceleration kind)
    : mesh_(mesh),
      constraints_(constraints),
      kind_(kind),
      history_(kind == Acceleration::anderson ? kAndersonMemory : kLbfgsMemory) {}

std::optional<ProposedSteps> Accelerator::propose(const RelaxationState& state) const {
  if (kind_ == Acceleration::none) return std::nullopt;
  const TangentField gradient = energy_gradient(state);
  TangentField smooth = gradient;
  for (std::size_t i = 0; i < gradient.size(); ++i) {
    if (is_at_kink(state, i)) smooth[i] = Vec2::Zero();
  }
  ProposedSteps proposed{direction(state, smooth), 0};
  for (std::size_t i = 0; i < gradient.size(); ++i) {
    Vec2& step = proposed.steps[i];
    const double longest = kLongestStep * std::max(state.mean_cell_radius, state.to_centroids[i].norm());
    if (!step.allFinite()) return std::nullopt;
    if (step.norm() > longest) step *= longest / step.norm();
    if (is_at_kink(state, i)) step = is_held(state, i) ? Vec2(Vec2::Zero()) : state.to_centroids[i];
    step = constraints_.project(mesh_, i, state.generators[i], step);
  }
  proposed.slope = dot(gradient, proposed.steps);
  if (!(proposed.slope < 0)) return std::nullopt;
  return proposed;
}

TangentField Accelerator::direction(const RelaxationState& state, const TangentField& gradient) const {
  if (kind_ == Acceleration::anderson) return anderson_step(history_, state.to_centroids);
  const EnergyHessian hessian(mesh_, state);
  return lbfgs_direction(history_, gradient, [&](const TangentField& field) { return hessian.solve(field); });
}

void Accelerator::learn(const RelaxationState& before, const GeneratorMove& move, const RelaxationState& after) {
  if (kind_ == Acceleration::none) return;
  history_.transport(move.turns);
  const bool by_gradient = kind_ == Acceleration::lbfgs;
  const TangentField start = by_gradient ? energy_gradient(before) : before.to_centroids;
  const TangentField end = by_gradient ? energy_gradient(after) : after.to_centroids;
  StepPair pair{move.step, add_scaled(end, -1, turned(move.turns, start))};
  for (std::size_t i = 0; i < pair.step.size(); ++i) {
    if (is_at_kink(before, i) || is_at_kink(after, i)) pair.step[i] = pair.change[i] = Vec2::Zero();
  }
  if (!by_gradient || has_curvature(pair, cell_masses(after))) history_.add(std::move(pair));
}

}  // namespace gvd
