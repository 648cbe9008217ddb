// Computes the Hessian of the energy from masses, moving bisectors, and paths that bend at vertices.
//
// Idea: a vertex at distance r with angle defect w bends the paths to the points behind it, up to the border of the
// cell at distance r + l. Along the ray behind it, two images of the generator meet in a ridge if w > 0; if w < 0, the
// paths spread in a wedge. To first order in w, both change the second derivative of the energy across the ray by -2 w
// l^3 / (3 r) times the density (docs/developer/lloyd.md, section 4). The distance of the border is found for sectors
// of directions, from the logarithms of the cell's vertices and bisectors. Near the vertex, this curvature is the
// curvature of a cone over the tangent plane, whose slope does not depend on r.
// The inverse is computed by a Lanczos process on the matrix relative to the masses. It uses the absolute values of the
// eigenvalues, so that every step lowers the energy if it is short enough.
#include "energy_hessian.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "gvd/surface_point.hpp"

namespace gvd {
namespace {

/// Number of steps of the Lanczos process.
constexpr int kLanczosSteps = 20;

/// Number of sectors of directions around a generator.
constexpr std::size_t kSectors = 32;

/// Divides each vector by the square root of its mass.
TangentField divided_by_roots(TangentField field, const std::vector<double>& masses) {
  for (std::size_t i = 0; i < field.size(); ++i) field[i] /= std::sqrt(masses[i]);
  return field;
}

/// How far each cell reaches in every sector of directions, mesh units.
class CellReach {
 public:
  explicit CellReach(const RelaxationState& state) : reach_(state.generators.size() * kSectors, 0.0) {
    const CellGeometry& geometry = state.geometry;
    for (const VertexId v : geometry.log.ids()) {
      if (geometry.label[v].valid()) note(geometry.label[v], geometry.log[v]);
    }
    for (const BisectorSegment& segment : geometry.segments) {
      for (const Vec2& log : segment.at_left) note(segment.left, log);
      for (const Vec2& log : segment.at_right) note(segment.right, log);
    }
  }
  double at(GeneratorId g, const Vec2& direction) const { return reach_[index(g, direction)]; }

 private:
  /// The number of the sector, computed along a diamond instead of a circle, which is faster than an angle.
  static std::size_t index(GeneratorId g, const Vec2& v) {
    const double sum = std::abs(v.x()) + std::abs(v.y());
    const double share = sum > 0 ? v.y() / sum : 0;  // from -1 to 1 on the right, and back on the left
    const double turn = 0.25 * (v.x() >= 0 ? 1 + share : 3 - share);
    return g.index() * kSectors + std::min(kSectors - 1, static_cast<std::size_t>(turn * double(kSectors)));
  }
  void note(GeneratorId g, const Vec2& log) {
    double& reach = reach_[index(g, log)];
    reach = std::max(reach, log.norm());
  }

  std::vector<double> reach_;
};

}  // namespace

IdVector<VertexId, double> angle_defects(const Mesh& mesh) {
  IdVector<VertexId, double> defects(mesh.vertex_count(), 2 * std::numbers::pi);
  for (const FaceId f : mesh.faces()) {
    for (int i = 0; i < 3; ++i) defects[mesh.vertices(f)[i]] -= corner_angle(mesh, Mesh::halfedge(f, i));
  }
  for (const VertexId v : mesh.vertices()) {
    if (!mesh.halfedge(v).valid() || mesh.is_boundary(v)) defects[v] = 0;
  }
  return defects;
}

EnergyHessian::EnergyHessian(const RelaxationState& state, const IdVector<VertexId, double>& defects, double scale,
                             double cone_reach)
    : masses_(cell_masses(state)), shadows_(masses_.size(), Eigen::Matrix2d::Zero()) {
  add_bisectors(state.geometry.segments);
  add_defects(state, defects, scale, cone_reach);
}

void EnergyHessian::add_bisectors(const std::vector<BisectorSegment>& segments) {
  for (const BisectorSegment& segment : segments) {
    const std::size_t left = segment.left.index(), right = segment.right.index();
    if (couplings_.empty() || couplings_.back().left != left || couplings_.back().right != right) {
      couplings_.push_back({left, right, Eigen::Matrix4d::Zero()});
    }
    for (std::size_t k = 0; k < 2; ++k) {
      Eigen::Vector4d v;
      v << segment.at_left[k], -segment.at_right[k];
      couplings_.back().form += segment.weight * v * v.transpose();
    }
  }
}

void EnergyHessian::add_defects(const RelaxationState& state, const IdVector<VertexId, double>& defects, double scale,
                                double cone_reach) {
  const CellReach reach(state);
  for (const VertexId v : state.geometry.log.ids()) {
    const GeneratorId g = state.geometry.label[v];
    const Vec2& log = state.geometry.log[v];
    const double distance = log.norm();
    if (!g.valid() || !(distance > 0) || defects[v] == 0) continue;
    const CellMoments& cell = state.moments[g];
    const double density = cell.area > 0 ? cell.mass / cell.area : 1;
    const double slope = -density * 2 * defects[v] * std::pow(reach.at(g, log) - distance, 3) / 3;
    if (distance < cone_reach) {
      cones_.push_back({g.index(), v, log, slope});
      continue;
    }
    const Vec2 across(-log.y() / distance, log.x() / distance);
    shadows_[g.index()] -= slope / std::hypot(distance, scale) * across * across.transpose();
  }
}

TangentField EnergyHessian::multiply_couplings(const TangentField& field) const {
  TangentField product = field;
  for (std::size_t i = 0; i < field.size(); ++i) product[i] = shadows_[i] * field[i];
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

TangentField EnergyHessian::solve_relative(const FieldMap& couplings, const TangentField& relative,
                                           double least) const {
  const auto inverse = [least](double coupling) { return 1 / std::max(std::abs(1 - coupling), least); };
  return divided_by_roots(apply_matrix_function(couplings, inverse, relative, kLanczosSteps), masses_);
}

TangentField EnergyHessian::solve(const TangentField& right, double least) const {
  const auto couplings = [&](const TangentField& field) {
    return divided_by_roots(multiply_couplings(divided_by_roots(field, masses_)), masses_);
  };
  return solve_relative(couplings, divided_by_roots(right, masses_), least);
}

TangentField EnergyHessian::solve(const TangentField& right, double least, const LocalTerms& local) const {
  const auto couplings = [&](const TangentField& field) {
    const TangentField step = divided_by_roots(field, masses_);
    TangentField product = multiply_couplings(step);
    for (std::size_t i = 0; i < step.size(); ++i) {
      product[i] = local.allowed[i] * Vec2(product[i] - local.curvature[i] * step[i]);
    }
    return divided_by_roots(product, masses_);
  };
  TangentField allowed = right;
  for (std::size_t i = 0; i < allowed.size(); ++i) allowed[i] = local.allowed[i] * right[i];
  return solve_relative(couplings, divided_by_roots(allowed, masses_), least);
}

}  // namespace gvd
