// Computes the convex combination map of a disc, in which every inner vertex is the weighted mean of its neighbours.
//
// If the border is convex and the weights are positive, the map is one-to-one. Mean value weights nearly preserve
// angles; the weights of needles are limited to a range, beyond which rounding would decide. `is_oriented` is certain:
// it accepts a triangle only if the sign of its orientation does not depend on rounding.
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

/// The weights of one vertex differ at most by this factor. The weights of needles can be nearly infinite or nearly 0,
/// and with a larger range rounding would decide where their corners are.
constexpr double kWeightRange = 1e4;

/// The tangent of half the angle at `at`; large where the angle is nearly pi.
double half_tangent(const Vec3& at, const Vec3& a, const Vec3& b) {
  const Vec3 to_a = a - at, to_b = b - at;
  const double lengths = to_a.norm() * to_b.norm();
  return to_a.cross(to_b).norm() / std::max(lengths + to_a.dot(to_b), lengths / kWeightRange);
}

/// Collects the vertices of the faces in ascending order, with the given points on the border.
PlaneDisc number_disc(const Mesh& mesh, const std::vector<FaceId>& faces, const std::vector<DiscBorderPoint>& border) {
  PlaneDisc disc;
  for (const FaceId f : faces) {
    for (const VertexId v : mesh.vertices(f)) disc.vertices.push_back(v);
  }
  std::sort(disc.vertices.begin(), disc.vertices.end());
  disc.vertices.erase(std::unique(disc.vertices.begin(), disc.vertices.end()), disc.vertices.end());
  disc.points.assign(disc.vertices.size(), Vec2::Zero());
  for (const DiscBorderPoint& b : border) disc.points[disc.number(b.vertex)] = b.point;
  return disc;
}

/// The weight of vertex `to` in the mean of vertex `from`. Both are numbers within the disc.
struct MeanWeight {
  std::size_t from, to;
  double value;
};

/// Collects the weights of the inner vertices' neighbours, which sum to 1 for each vertex. `row`: -1 on the border.
std::vector<MeanWeight> collect_weights(const Mesh& mesh, const std::vector<FaceId>& faces, const PlaneDisc& disc,
                                        const std::vector<int>& row, DiscWeights kind) {
  const bool uniform = kind == DiscWeights::uniform;
  std::vector<MeanWeight> weights;
  for (const FaceId f : faces) {
    const auto& vertices = mesh.vertices(f);
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexId at = vertices[i], a = vertices[(i + 1) % 3], b = vertices[(i + 2) % 3];
      const std::size_t from = disc.number(at);
      if (row[from] < 0) continue;
      const Vec3 &p = mesh.position(at), &q = mesh.position(a), &r = mesh.position(b);
      const double tangent = uniform ? 1 : half_tangent(p, q, r);
      weights.push_back({from, disc.number(a), uniform ? 1 : tangent / (q - p).norm()});
      weights.push_back({from, disc.number(b), uniform ? 1 : tangent / (r - p).norm()});
    }
  }
  std::vector<double> largest(row.size(), 0), sum(row.size(), 0);
  for (const MeanWeight& w : weights) largest[w.from] = std::max(largest[w.from], w.value);
  for (MeanWeight& w : weights) {
    w.value = std::max(w.value / largest[w.from], 1 / kWeightRange);
    sum[w.from] += w.value;
  }
  for (MeanWeight& w : weights) w.value /= sum[w.from];
  return weights;
}

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

std::optional<PlaneDisc> flatten_disc(const Mesh& mesh, const std::vector<FaceId>& faces,
                                      const std::vector<DiscBorderPoint>& border, DiscWeights weights) {
  PlaneDisc disc = number_disc(mesh, faces, border);
  std::vector<int> row(disc.vertices.size(), 0);  // row of the matrix for each vertex, -1 on the border
  for (const DiscBorderPoint& b : border) row[disc.number(b.vertex)] = -1;
  int rows = 0;
  for (int& r : row) {
    if (r == 0) r = rows++;
  }
  if (rows == 0) return disc;
  Eigen::SparseMatrix<double> matrix(rows, rows);
  Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(rows, 2);
  std::vector<Eigen::Triplet<double>> entries;
  for (const MeanWeight& w : collect_weights(mesh, faces, disc, row, weights)) {
    if (row[w.to] < 0) {
      right.row(row[w.from]) += w.value * disc.points[w.to].transpose();
    } else {
      entries.emplace_back(row[w.from], row[w.to], -w.value);
    }
  }
  for (int r = 0; r < rows; ++r) entries.emplace_back(r, r, 1);
  matrix.setFromTriplets(entries.begin(), entries.end());
  matrix.makeCompressed();
  const Eigen::SparseLU<Eigen::SparseMatrix<double>> factors(matrix);
  if (factors.info() != Eigen::Success) return std::nullopt;
  const Eigen::MatrixX2d solution = factors.solve(right);
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (row[i] >= 0) disc.points[i] = solution.row(row[i]).transpose();
  }
  return disc;
}

bool is_oriented(const Mesh& mesh, const std::vector<FaceId>& faces, const PlaneDisc& disc) {
  return std::all_of(faces.begin(), faces.end(), [&](FaceId f) {
    const auto& [a, b, c] = mesh.vertices(f);
    return orientation(disc.at(a), disc.at(b), disc.at(c)) > 0;
  });
}

}  // namespace gvd
