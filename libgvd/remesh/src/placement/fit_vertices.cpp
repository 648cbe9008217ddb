#include "placement/fit_vertices.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <array>

#include "base/parallel_chunks.hpp"
#include "gvd/closest_point.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {
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

  /// Of the samples of the surface.
  std::vector<Residual> find_there() const {
    return collect(target_.samples, tree_, [this](const SurfaceSample& sample, FaceId nearest) {
      const ClosestPoint closest = closest_point_on_face(remesh_, nearest, sample.position);
      return make(closest.point, sample.position, face_normal(remesh_, nearest), sample);
    });
  }

  /// Of samples of the remesh.
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
    for (std::size_t k = 0; k < 3; ++k) row.segment<3>(static_cast<Eigen::Index>(3 * k)) = r.bary[k] * r.direction;
    systems[r.face].matrix += r.area * row * row.transpose();
    systems[r.face].right += r.area * r.distance * row;
  }
}

IdVector<FaceId, FaceSystem> sum_up(const Mesh& remesh, const FitTarget& target) {
  IdVector<FaceId, FaceSystem> systems(static_cast<std::size_t>(remesh.face_count()));
  const ResidualFinder finder(remesh, target);
  add_up(finder.find_there(), systems);
  add_up(finder.find_back(), systems);
  return systems;
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
  const auto systems = sum_up(remesh, target);
  for (std::int32_t f = 0; f < remesh.face_count(); ++f) {
    const auto& corners = remesh.vertices(FaceId(f));
    const FaceSystem& system = systems[FaceId(f)];
    const auto row = [&](int i) { return 3 * corners[i / 3].value() + i % 3; };
    for (int i = 0; i < 9; ++i) {
      all.right[row(i)] += system.right[i];
      for (int j = 0; j < 9; ++j) all.add(row(i), row(j), system.matrix(i, j));
    }
  }
}

void add_springs(const Mesh& remesh, const std::vector<VertexAnchor>& anchors, VertexSystem& all) {
  for (std::int32_t v = 0; v < remesh.vertex_count(); ++v) {
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
  for (std::size_t v = 0; v < positions.size(); ++v) {
    positions[v] += solution.segment<3>(static_cast<Eigen::Index>(3 * v));
  }
  return positions;
}

}  // namespace gvd
