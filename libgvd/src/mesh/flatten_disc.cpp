// The convex combination map of a disc: every inner vertex is the weighted mean of its neighbours.
//
// If the border is convex and the weights are positive, the map is one-to-one. Mean value weights nearly keep the
// angles; those of needles are limited to a range, beyond which rounding would decide. The check that no triangle is
// turned round is certain: it counts a triangle only where the orientation's sign does not depend on rounding.
// Sources: M. Floater, One-to-one piecewise linear mappings over triangulations, 2003; for the weights, M. Floater, Mean
// value coordinates, 2003.

#include "mesh/flatten_disc.hpp"

#include <Eigen/SparseLU>
#include <cmath>

#include "base/plane.hpp"
#include "gvd/error.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

/// Weights of one vertex differ by this factor at most: needles have nearly infinite ones, and nearly none. With more,
/// rounding would decide where their corners are.
constexpr double kWeightRange = 1e4;

/// The tangent of half the angle at `at`; large where the angle is nearly pi.
double half_tangent(const Vec3& at, const Vec3& a, const Vec3& b) {
  const Vec3 to_a = a - at, to_b = b - at;
  const double lengths = to_a.norm() * to_b.norm();
  return to_a.cross(to_b).norm() / std::max(lengths + to_a.dot(to_b), lengths / kWeightRange);
}

class DiscFlattener {
 public:
  DiscFlattener(const Mesh& mesh, const std::vector<FaceId>& faces, const std::vector<BorderPoint>& border)
      : mesh_(mesh), faces_(faces) {
    for (const FaceId f : faces) {
      for (const VertexId v : mesh.vertices(f)) disc_.vertices.push_back(v);
    }
    std::sort(disc_.vertices.begin(), disc_.vertices.end());
    disc_.vertices.erase(std::unique(disc_.vertices.begin(), disc_.vertices.end()), disc_.vertices.end());
    disc_.points.assign(disc_.vertices.size(), Vec2::Zero());
    row_.assign(disc_.vertices.size(), 0);
    for (const BorderPoint& b : border) {
      disc_.points[disc_.number(b.vertex)] = b.point;
      row_[disc_.number(b.vertex)] = -1;
    }
    for (int& row : row_) {
      if (row == 0) row = rows_++;
    }
  }

  PlaneDisc run(DiscWeights weights) {
    if (rows_ == 0) return std::move(disc_);
    collect(weights);
    Eigen::SparseMatrix<double> matrix(rows_, rows_);
    Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(rows_, 2);
    fill(matrix, right);
    const Eigen::SparseLU<Eigen::SparseMatrix<double>> factors(matrix);
    if (factors.info() != Eigen::Success) throw Error(ErrorCode::no_valid_result, "a cell can't be flattened");
    const Eigen::MatrixX2d solution = factors.solve(right);
    for (std::size_t i = 0; i < row_.size(); ++i) {
      if (row_[i] >= 0) disc_.points[i] = solution.row(row_[i]).transpose();
    }
    return std::move(disc_);
  }

 private:
  /// The weight of vertex `to` in the mean of vertex `from`; numbers in the disc.
  struct Weight {
    std::size_t from, to;
    double value;
  };

  void collect(DiscWeights weights) {
    for (const FaceId f : faces_) {
      const auto& vertices = mesh_.vertices(f);
      for (std::size_t i = 0; i < 3; ++i) {
        const VertexId at = vertices[i], a = vertices[(i + 1) % 3], b = vertices[(i + 2) % 3];
        const std::size_t from = disc_.number(at);
        if (row_[from] < 0) continue;
        const Vec3 &p = mesh_.position(at), &q = mesh_.position(a), &r = mesh_.position(b);
        const bool uniform = weights == DiscWeights::uniform;
        const double tangent = uniform ? 1 : half_tangent(p, q, r);
        weights_.push_back({from, disc_.number(a), uniform ? 1 : tangent / (q - p).norm()});
        weights_.push_back({from, disc_.number(b), uniform ? 1 : tangent / (r - p).norm()});
      }
    }
  }

  void fill(Eigen::SparseMatrix<double>& matrix, Eigen::MatrixX2d& right) {
    std::vector<double> largest(row_.size(), 0), sum(row_.size(), 0);
    for (const Weight& w : weights_) largest[w.from] = std::max(largest[w.from], w.value);
    for (Weight& w : weights_) {
      w.value = std::max(w.value / largest[w.from], 1 / kWeightRange);
      sum[w.from] += w.value;
    }
    std::vector<Eigen::Triplet<double>> entries;
    for (const Weight& w : weights_) {
      const double share = w.value / sum[w.from];
      if (row_[w.to] < 0) {
        right.row(row_[w.from]) += share * disc_.points[w.to].transpose();
      } else {
        entries.emplace_back(row_[w.from], row_[w.to], -share);
      }
    }
    for (int row = 0; row < rows_; ++row) entries.emplace_back(row, row, 1);
    matrix.setFromTriplets(entries.begin(), entries.end());
    matrix.makeCompressed();
  }

  const Mesh& mesh_;
  const std::vector<FaceId>& faces_;
  PlaneDisc disc_;
  std::vector<int> row_;  ///< per vertex: of the matrix, -1 on the border
  int rows_ = 0;
  std::vector<Weight> weights_;
};

}  // namespace

std::vector<VertexId> trace_boundary_loop(const Mesh& mesh, HalfedgeId h) {
  std::vector<VertexId> loop;
  HalfedgeId next = h;
  do {
    loop.push_back(mesh.from(next));
    next = next_on_boundary(mesh, next);
  } while (next != h);
  return loop;
}

void scale_and_even(std::vector<double>& values, double last, double even_share) {
  const double given = values.back(), steps = double(values.size() - 1);
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = last * ((1 - even_share) * values[i] / given + even_share * double(i) / steps);
  }
  values.back() = last;
}

std::vector<Vec2> lay_round(const std::vector<double>& angles, const std::vector<double>& radii) {
  std::vector<Vec2> points;
  for (std::size_t i = 0; i + 1 < angles.size(); ++i) points.push_back(radii[i] * unit_vector(angles[i]));
  return points;
}

PlaneDisc flatten_disc(const Mesh& mesh, const std::vector<FaceId>& faces, const std::vector<BorderPoint>& border,
                       DiscWeights weights) {
  return DiscFlattener(mesh, faces, border).run(weights);
}

bool is_oriented(const Mesh& mesh, const std::vector<FaceId>& faces, const PlaneDisc& disc) {
  return std::all_of(faces.begin(), faces.end(), [&](FaceId f) {
    const auto& [a, b, c] = mesh.vertices(f);
    return orientation(disc.at(a), disc.at(b), disc.at(c)) > 0;
  });
}

}  // namespace gvd
