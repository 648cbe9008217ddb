// A round of the fit: the vertex positions with the least sum of square distances and springs.
//
// Each sample of one surface and its closest point of the other give a plane; the square distance from it is a
// quadratic function of the three corners of a face. The sums of a face are a block of 9 x 9, and the blocks and the
// springs one sparse system over all vertices. Samples are taken in both directions, or parts of the mesh would leave
// the surface unnoticed. The sums are formed in the order of the samples, for any number of threads.
// docs/notes/remesh-placement.md has the measurements that chose it.

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>

#include "base/parallel_chunks.hpp"
#include "placement_steps.hpp"

namespace gvd {

std::vector<SurfaceSample> sample_surface(const Mesh& mesh, double count) {
  const double total = compute_area(mesh);
  std::vector<SurfaceSample> samples;
  for (const FaceId f : mesh.faces()) {
    const auto& [a, b, c] = mesh.vertices(f);
    const Vec3 &p = mesh.position(a), u = mesh.position(b) - p, v = mesh.position(c) - p;
    if (!(mesh.area(f) > 0)) continue;
    const int k = std::max(1, static_cast<int>(std::lround(std::sqrt(mesh.area(f) / total * count))));
    const double area = mesh.area(f) / (k * k);
    const Vec3 normal = face_normal(mesh, f);
    for (int s = 0; s < k; ++s) {
      for (int t = 0; s + t < k; ++t) {
        const auto add = [&](double third) {
          samples.push_back({p + (s + third) / k * u + (t + third) / k * v, normal, f, area});
        };
        add(1.0 / 3);
        if (s + t + 1 < k) add(2.0 / 3);
      }
    }
  }
  return samples;
}

namespace {

constexpr std::size_t kSamplesPerChunk = 1024;

/// A point of the remesh and how far it should move along a direction.
struct Residual {
  FaceId face;  ///< of the remesh; invalid where the pair does not count
  std::array<double, 3> bary{};
  Vec3 direction;
  double distance = 0;
  double area = 0;
};

using Block = Eigen::Matrix<double, 9, 9>;
using Column = Eigen::Matrix<double, 9, 1>;

/// The normal equations of the samples of one face, over the moves of its three corners.
struct FaceSystem {
  Block matrix = Block::Zero();
  Column right = Column::Zero();
};

class ResidualFinder {
 public:
  ResidualFinder(const Mesh& remesh, const FitTarget& target) : remesh_(remesh), target_(target), tree_(remesh) {}

  /// The residuals of samples of the surface.
  std::vector<Residual> find_there() const {
    return collect(target_.samples, tree_, [this](const SurfaceSample& sample, FaceId nearest) {
      const ClosestPoint closest = closest_point_on_face(remesh_, nearest, sample.position);
      return make(closest.point, sample.position, face_normal(remesh_, nearest), sample);
    });
  }

  /// The residuals of samples of the remesh.
  std::vector<Residual> find_back() const {
    const auto samples = sample_surface(remesh_, target_.count);
    return collect(samples, *target_.tree, [this](const SurfaceSample& sample, FaceId nearest) {
      const ClosestPoint closest = closest_point_on_face(*target_.surface, nearest, sample.position);
      const SurfacePoint at = closest_point_on_face(remesh_, sample.face, sample.position).point;
      return make(at, position(*target_.surface, closest.point), face_normal(*target_.surface, nearest), sample);
    });
  }

 private:
  /// Calls residual(sample, nearest face) of every sample.
  template <class Find>
  std::vector<Residual> collect(const std::vector<SurfaceSample>& samples, const ClosestPointTree& tree,
                                const Find& residual) const {
    const Progress none;
    const auto chunks = cut_into_chunks(samples.size(), kSamplesPerChunk);
    return ParallelChunks(target_.threads, none).collect(chunks, {"fit"}, [&](const Chunk& chunk) {
      std::vector<Residual> residuals;
      FaceId nearest(0);
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
        nearest = tree.nearest_face(samples[i].position, nearest).face;
        residuals.push_back(residual(samples[i], nearest));
      }
      return residuals;
    });
  }

  /// `normal`: of the face that the sample's closest point lies on.
  Residual make(const SurfacePoint& from, const Vec3& to, const Vec3& normal, const SurfaceSample& sample) const {
    if (normal.dot(sample.normal) < 0) return {};
    const Vec3 way = to - position(remesh_, from);
    const bool touches = way.norm() <= kCoincidence * target_.surface->bbox_diagonal();
    const Vec3 direction = touches ? normal : way.normalized();
    return {from.face, from.bary, direction, touches ? 0 : way.norm(), sample.area};
  }

  const Mesh& remesh_;
  const FitTarget& target_;
  ClosestPointTree tree_;
};

void add_up(const std::vector<Residual>& residuals, IdVector<FaceId, FaceSystem>& systems) {
  for (const Residual& r : residuals) {
    if (!r.face.valid()) continue;
    Column row;
    for (int k = 0; k < 3; ++k) row.segment<3>(3 * k) = r.bary[k] * r.direction;
    systems[r.face].matrix += r.area * row * row.transpose();
    systems[r.face].right += r.area * r.distance * row;
  }
}

/// The normal equations over the moves of all vertices.
struct VertexSystem {
  std::vector<Eigen::Triplet<double>> entries;  ///< on the diagonal and below: the matrix is symmetric
  Eigen::VectorXd right;

  void add(int row, int column, double value) {
    if (row >= column) entries.emplace_back(row, column, value);
  }
};

void add_samples(const Mesh& remesh, const FitTarget& target, VertexSystem& all) {
  IdVector<FaceId, FaceSystem> systems(remesh.face_count());
  const ResidualFinder finder(remesh, target);
  add_up(finder.find_there(), systems);
  add_up(finder.find_back(), systems);
  for (const FaceId f : remesh.faces()) {
    const auto& corners = remesh.vertices(f);
    const FaceSystem& system = systems[f];
    const auto row = [&](int i) { return 3 * corners[i / 3].value() + i % 3; };
    for (int i = 0; i < 9; ++i) {
      all.right[row(i)] += system.right[i];
      for (int j = 0; j < 9; ++j) all.add(row(i), row(j), system.matrix(i, j));
    }
  }
}

void add_springs(const Mesh& remesh, const std::vector<VertexAnchor>& anchors, VertexSystem& all) {
  for (int v = 0; v < remesh.vertex_count(); ++v) {
    const VertexAnchor& anchor = anchors[v];
    all.right.segment<3>(3 * v) += anchor.weight * (anchor.position - remesh.position(VertexId(v)));
    for (int i = 0; i < 9; ++i) all.add(3 * v + i / 3, 3 * v + i % 3, anchor.weight(i / 3, i % 3));
  }
}

Eigen::VectorXd solve(const VertexSystem& system) {
  Eigen::SparseMatrix<double> matrix(system.right.size(), system.right.size());
  matrix.setFromTriplets(system.entries.begin(), system.entries.end());
  return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower>(matrix).solve(system.right);
}

}  // namespace

std::vector<Vec3> fit_vertices(const Mesh& remesh, const FitTarget& target, const std::vector<VertexAnchor>& anchors) {
  VertexSystem system{{}, Eigen::VectorXd::Zero(3 * remesh.vertex_count())};
  add_samples(remesh, target, system);
  add_springs(remesh, anchors, system);
  const Eigen::VectorXd solution = solve(system);
  std::vector<Vec3> positions = remesh.positions();
  if (!solution.allFinite()) return positions;
  for (int v = 0; v < remesh.vertex_count(); ++v) positions[v] += solution.segment<3>(3 * v);
  return positions;
}

}  // namespace gvd
