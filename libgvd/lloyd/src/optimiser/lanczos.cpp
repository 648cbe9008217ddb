#include "lanczos.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <vector>

namespace gvd {
namespace {

/// A new basis vector below this length, relative to the largest entry of the tridiagonal matrix, is rounding.
constexpr double kInvariant = 1e-10;

/// An orthonormal basis of the Krylov space, and the matrix in this basis, which is tridiagonal.
struct KrylovBasis {
  std::vector<TangentField> vectors;
  std::vector<double> diagonal, beside;
};

/// Two rounds make the vector orthogonal to the basis up to rounding.
TangentField orthogonalised(TangentField w, const std::vector<TangentField>& basis) {
  for (int round = 0; round < 2; ++round) {
    for (const TangentField& v : basis) {
      const double along = dot(w, v);  // before w is moved: arguments are evaluated in any order
      w = add_scaled(std::move(w), -along, v);
    }
  }
  return w;
}

KrylovBasis build_basis(const std::function<TangentField(const TangentField&)>& multiply, TangentField first,
                        int steps) {
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

/// f of the tridiagonal matrix, its first column.
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

TangentField apply_matrix_function(const std::function<TangentField(const TangentField&)>& multiply,
                                   const std::function<double(double)>& f, const TangentField& b, int steps) {
  TangentField result(b.size(), Vec2::Zero());
  const double length = std::sqrt(dot(b, b));
  if (!(length > 0)) return result;
  const KrylovBasis basis = build_basis(multiply, scaled(b, 1 / length), steps);
  const Eigen::VectorXd factors = first_column(basis, f);
  for (std::size_t i = 0; i < basis.vectors.size(); ++i) {
    result = add_scaled(std::move(result), length * factors[static_cast<Eigen::Index>(i)], basis.vectors[i]);
  }
  return result;
}

}  // namespace gvd
