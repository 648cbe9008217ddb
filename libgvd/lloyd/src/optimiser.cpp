// Methods of optimisation on fields of tangent vectors: L-BFGS, the Lanczos process, and a line search.
//
// Nothing here depends on a mesh or an energy. The vectors of all earlier steps are transported along the generators'
// paths, so that differences are formed in the same tangent plane for each generator. Sums run in ascending order of
// the generators, so that every run gives the same bits. Sources are with the declarations.
#include "optimiser.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

namespace gvd {
namespace {

/// The factor that gives the initial inverse Hessian the curvature of the latest pair.
double initial_factor(const StepHistory& history, const FieldMap& initial) {
  if (history.pairs().empty()) return 1;
  const StepPair& latest = history.pairs().back();
  return dot(latest.step, latest.change) / dot(latest.change, initial(latest.change));
}

/// A new basis vector shorter than this, relative to the largest entry of the tridiagonal matrix, is only rounding.
constexpr double kInvariant = 1e-10;

/// An orthonormal basis of the Krylov space, and the matrix in this basis, which is tridiagonal.
struct KrylovBasis {
  std::vector<TangentField> vectors;
  std::vector<double> diagonal, beside;
};

/// The part of a vector that is orthogonal to the basis, up to rounding. That takes two rounds.
TangentField orthogonalised(TangentField w, const std::vector<TangentField>& basis) {
  for (int round = 0; round < 2; ++round) {
    for (const TangentField& v : basis) {
      const double along = dot(w, v);  // before w is moved, because arguments are evaluated in any order
      w = add_scaled(std::move(w), -along, v);
    }
  }
  return w;
}

KrylovBasis build_basis(const FieldMap& multiply, TangentField first, int steps) {
  KrylovBasis basis;
  basis.vectors.push_back(std::move(first));
  double largest = 0;
  while (true) {
    TangentField w = multiply(basis.vectors.back());
    basis.diagonal.push_back(dot(w, basis.vectors.back()));
    w = orthogonalised(std::move(w), basis.vectors);
    const double length = std::sqrt(dot(w, w));
    largest = std::max({largest, std::abs(basis.diagonal.back()), length});
    if (std::ssize(basis.diagonal) >= steps || !(length > kInvariant * largest)) return basis;
    basis.beside.push_back(length);
    basis.vectors.push_back(scaled(std::move(w), 1 / length));
  }
}

/// The first column of f(T), where T is the tridiagonal matrix.
Eigen::VectorXd first_column(const KrylovBasis& basis, const std::function<double(double)>& f) {
  const Eigen::Index n = std::ssize(basis.diagonal);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    matrix(i, i) = basis.diagonal[i];
    if (i + 1 < n) matrix(i, i + 1) = matrix(i + 1, i) = basis.beside[i];
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(matrix);
  const Eigen::VectorXd values = eigen.eigenvalues().unaryExpr(f);
  return eigen.eigenvectors() * values.cwiseProduct(eigen.eigenvectors().row(0).transpose());
}

}  // namespace

TangentField lbfgs_direction(const StepHistory& history, const TangentField& gradient, const FieldMap& initial) {
  TangentField q = gradient;
  std::vector<double> alphas;
  for (auto pair = history.pairs().rbegin(); pair != history.pairs().rend(); ++pair) {
    alphas.push_back(dot(pair->step, q) / dot(pair->step, pair->change));
    q = add_scaled(std::move(q), -alphas.back(), pair->change);
  }
  TangentField r = scaled(initial(q), initial_factor(history, initial));
  for (const StepPair& pair : history.pairs()) {
    const double beta = dot(pair.change, r) / dot(pair.step, pair.change);
    r = add_scaled(std::move(r), alphas.back() - beta, pair.step);
    alphas.pop_back();
  }
  return scaled(std::move(r), -1);
}

TangentField apply_matrix_function(const FieldMap& multiply, const std::function<double(double)>& f,
                                   const TangentField& b, int steps) {
  TangentField result(b.size(), Vec2::Zero());
  const double length = std::sqrt(dot(b, b));
  if (!(length > 0)) return result;
  const KrylovBasis basis = build_basis(multiply, scaled(b, 1 / length), steps);
  const Eigen::VectorXd factors = first_column(basis, f);
  for (int i = 0; i < std::ssize(basis.vectors); ++i) {
    result = add_scaled(std::move(result), length * factors[i], basis.vectors[i]);
  }
  return result;
}

double shorter_scale(double scale, double slope, double rise) {
  if (!std::isfinite(rise)) return 0.1 * scale;
  const double lowest = -slope * scale * scale / (2 * (rise - slope * scale));
  return std::clamp(lowest, 0.1 * scale, 0.5 * scale);
}

}  // namespace gvd
