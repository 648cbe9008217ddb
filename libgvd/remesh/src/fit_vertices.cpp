// A round of the fit: the vertex positions with the least sum of square distances and springs.
//
// Along a smooth surface a spring pulls a vertex to where its triangles are nearly equilateral: the mean of the apexes
// of equilateral triangles over the opposite edges, in which bad triangles weigh more. Across the surface, at creases
// and beside them the samples decide, and springs only keep the system regular. Weights are fractions of a cell's area,
// so that they compare with the samples of the cell, whatever its size.
//
// Each sample of one surface and its closest point of the other give a plane; the square distance from it is a
// quadratic function of the three corners of a face. The sums of a face are a block of 9 x 9, and the blocks and the
// springs form one sparse system over all vertices. Samples are taken in both directions, because otherwise parts of
// the mesh could leave the surface unnoticed. The sums are formed in the order of the samples, for any number of
// threads. docs/notes/remesh-placement.md has the measurements behind this method.

#include "fit_vertices.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel_chunks.hpp"
#include "base/triangle_lattice.hpp"
#include "cell_quadrics.hpp"

namespace gvd {
namespace {

/// Bounds the weight of triangles that have hardly any area.
constexpr double kLeastQuality = 0.05;

/// Sums over the faces of a vertex.
struct ShapeSum {
  Vec3 apexes = Vec3::Zero();
  Vec3 normal = Vec3::Zero();
  double weight = 0;
};

void add_face(const std::array<VertexId, 3>& vertices, const Mesh& mesh, std::vector<ShapeSum>& sums) {
  const std::array<Vec3, 3> at{mesh.position(vertices[0]), mesh.position(vertices[1]), mesh.position(vertices[2])};
  const Vec3 normal = (at[1] - at[0]).cross(at[2] - at[0]);
  const double squares = (at[1] - at[0]).squaredNorm() + (at[2] - at[1]).squaredNorm() + (at[0] - at[2]).squaredNorm();
  const double quality = 2 * std::sqrt(3.0) * normal.norm() / squares;
  const double weight = 1 / std::max(kLeastQuality, quality);
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 &a = at[(k + 1) % 3], &b = at[(k + 2) % 3];
    const Vec3 height = std::sqrt(3.0) / 2 * normal.normalized().cross(b - a);
    ShapeSum& sum = sums[vertices[k].index()];
    sum.apexes += weight * ((a + b) / 2 + height);
    sum.normal += normal;
    sum.weight += weight;
  }
}

/// Weight of the springs along the surface, as a fraction of a cell's area. They pull towards better triangles, and
/// matter where the distances hardly change. In such a direction the samples weigh r^2 / 4 of the area, for a cell with
/// an angular radius of r. So springs outweigh the samples of cells below three quarters of a radian.
/// docs/notes/remesh-placement.md compares it with .2 and .3, and with .02 beside creases.
constexpr double kSmoothSpring = 0.15;

/// Weight of the springs along a crease.
constexpr double kAlongCreaseSpring = 0.03;

/// Weight across creases and beside them, where the samples decide: triangles miss the crease unless vertices move.
constexpr double kCreaseSpring = 0.001;

/// Weight across the surface, where the samples alone decide as well. It keeps the system regular.
constexpr double kNormalSpring = 0.001;

/// Weight of the spring of a vertex that stays: a million times the samples of its cell, and far from the limits of the
/// factorisation.
constexpr double kRigidSpring = 1e6;

using Matrix = Eigen::Matrix3d;

/// The projection to the direction of a unit vector, or to nothing.
Matrix onto(const Vec3& direction) { return direction * direction.transpose(); }

constexpr std::size_t kSamplesPerChunk = 1024;

/// A point of the remesh and how far it should move along a direction.
struct Residual {
  FaceId face;  ///< of the remesh; invalid where the pair does not count
  std::array<double, 3> bary{};
  Vec3 direction;
  double distance = 0;
  double area = 0;
};

class ResidualFinder {
 public:
  ResidualFinder(const Mesh& remesh, const FitTarget& target) : remesh_(remesh), target_(target), tree_(remesh) {}

  /// The residuals of samples of the surface.
  std::vector<Residual> find_there() const {
    return collect(target_.samples, tree_, [this](const AreaSample& sample, FaceId nearest) {
      const ClosestPoint closest = closest_point_on_face(remesh_, nearest, sample.position);
      return make(closest.point, sample.position, face_normal(remesh_, nearest), sample);
    });
  }

  /// The residuals of samples of the remesh.
  std::vector<Residual> find_back() const {
    const auto samples = sample_surface(remesh_, target_.count);
    return collect(samples, *target_.tree, [this](const AreaSample& sample, FaceId nearest) {
      const ClosestPoint closest = closest_point_on_face(*target_.surface, nearest, sample.position);
      const SurfacePoint at = closest_point_on_face(remesh_, sample.face, sample.position).point;
      return make(at, position(*target_.surface, closest.point), face_normal(*target_.surface, nearest), sample);
    });
  }

 private:
  /// Calls residual(sample, nearest face) of every sample.
  template <class Find>
  std::vector<Residual> collect(const std::vector<AreaSample>& samples, const ClosestPointTree& tree,
                                const Find& residual) const {
    const auto chunks = cut_into_chunks(samples.size(), kSamplesPerChunk);
    return ParallelChunks(target_.threads, target_.progress).collect(chunks, {"fit"}, [&](const Chunk& chunk) {
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
  Residual make(const SurfacePoint& from, const Vec3& to, const Vec3& normal, const AreaSample& sample) const {
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

void add_up(const std::vector<Residual>& residuals, FaceSystems& systems) {
  for (const Residual& r : residuals) {
    if (!r.face.valid()) continue;
    FaceSystem::Column row;
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

void add_samples(const Mesh& remesh, const FaceSystems& systems, VertexSystem& all) {
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

/// Eigen reports nothing from inside its steps, so that progress is only told between them.
Eigen::VectorXd solve(const VertexSystem& system, const Progress& progress) {
  const auto report = [&] { report_progress(progress, "fit", 1); };
  Eigen::SparseMatrix<double> matrix(system.right.size(), system.right.size());
  matrix.setFromTriplets(system.entries.begin(), system.entries.end());
  report();
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> solver;
  solver.analyzePattern(matrix);
  report();
  solver.factorize(matrix);
  report();
  return solver.solve(system.right);
}

}  // namespace

std::vector<VertexShape> find_vertex_shapes(const Mesh& mesh) {
  std::vector<ShapeSum> sums(mesh.positions().size());
  for (const FaceId f : mesh.faces()) add_face(mesh.vertices(f), mesh, sums);
  std::vector<VertexShape> shapes;
  for (std::size_t v = 0; v < sums.size(); ++v) {
    const ShapeSum& sum = sums[v];
    const Vec3& here = mesh.positions()[v];
    shapes.push_back({sum.weight > 0 ? Vec3(sum.apexes / sum.weight) : here, sum.normal.normalized()});
  }
  return shapes;
}

std::vector<VertexRole> find_vertex_roles(const Mesh& remesh, const IdVector<GeneratorId, CreaseCell>& creases,
                                          const std::vector<char>& held) {
  std::vector<VertexRole> roles(held.size(), VertexRole::free);
  const auto is_creased = [&](VertexId v) { return creases[GeneratorId(v.value())].is_creased; };
  for (const EdgeId e : remesh.edges()) {
    const HalfedgeId h = remesh.halfedge(e);
    if (is_creased(remesh.from(h))) roles[remesh.to(h).index()] = VertexRole::near_crease;
    if (is_creased(remesh.to(h))) roles[remesh.from(h).index()] = VertexRole::near_crease;
  }
  for (const VertexId v : remesh.vertices()) {
    if (is_creased(v)) roles[v.index()] = VertexRole::at_crease;
    if (held[v.index()]) roles[v.index()] = VertexRole::held;
  }
  return roles;
}

std::vector<VertexAnchor> make_springs(const Mesh& current, const SpringPlan& plan) {
  const std::vector<VertexShape> shapes = find_vertex_shapes(current);
  const Matrix identity = Matrix::Identity();
  std::vector<VertexAnchor> springs;
  for (std::size_t v = 0; v < shapes.size(); ++v) {
    const Vec3& here = current.positions()[v];
    const Vec3 better = shapes[v].position - here, back = plan.remesh->positions()[v] - here;
    const Matrix across = onto(shapes[v].normal), tangent = identity - across;
    const Vec3& direction = plan.creases[GeneratorId(v)].direction;
    const Matrix along = onto(direction), beside = identity - along;
    const auto add = [&](const Vec3& way, const Matrix& weight) {
      springs.push_back({here + way, plan.areas[v] * weight});
    };
    switch (plan.roles[v]) {
      case VertexRole::free:
        add(tangent * better, plan.stiffness * kSmoothSpring * tangent + kNormalSpring * across);
        break;
      case VertexRole::near_crease:
        add(tangent * better, plan.stiffness * kCreaseSpring * tangent + kNormalSpring * across);
        break;
      case VertexRole::at_crease:
        add(along * better + beside * tangent * back,
            plan.stiffness * (kAlongCreaseSpring * along + kCreaseSpring * beside * tangent * beside) +
                kNormalSpring * identity);
        break;
      case VertexRole::held:
        add(Vec3(0, 0, 0), kRigidSpring * identity);
        break;
    }
  }
  return springs;
}

std::vector<AreaSample> sample_surface(const Mesh& mesh, double count) {
  const double total = compute_area(mesh);
  std::vector<AreaSample> samples;
  for (const FaceId f : mesh.faces()) {
    const auto& [a, b, c] = mesh.vertices(f);
    const Vec3 &p = mesh.position(a), u = mesh.position(b) - p, v = mesh.position(c) - p;
    if (!(mesh.area(f) > 0)) continue;
    const int k = std::max(1, static_cast<int>(std::lround(std::sqrt(mesh.area(f) / total * count))));
    const double area = mesh.area(f) / (k * k);
    const Vec3 normal = face_normal(mesh, f);
    for_each_lattice_triangle(k, [&](int s, int t, bool is_upright) {
      const double third = is_upright ? 1.0 / 3 : 2.0 / 3;
      samples.push_back({p + (s + third) / k * u + (t + third) / k * v, normal, f, area});
    });
  }
  return samples;
}

std::vector<AreaSample> thin_out(std::vector<AreaSample> samples, double most) {
  if (double(samples.size()) <= most) return samples;
  double total = 0, carried = 0;
  for (const AreaSample& s : samples) total += s.area;
  std::vector<AreaSample> left;
  for (const AreaSample& s : samples) {
    carried += s.area;
    if (carried * most < total) continue;
    left.push_back(s);
    left.back().area = std::exchange(carried, 0);
  }
  if (!left.empty()) left.back().area += carried;
  return left;
}

FaceSystems find_face_systems(const Mesh& remesh, const FitTarget& target) {
  FaceSystems systems(remesh.face_count());
  const ResidualFinder finder(remesh, target);
  add_up(finder.find_there(), systems);
  add_up(finder.find_back(), systems);
  return systems;
}

std::vector<Vec3> fit_vertices(const Mesh& remesh, const FaceSystems& systems, const std::vector<VertexAnchor>& anchors,
                               const Progress& progress) {
  VertexSystem system{{}, Eigen::VectorXd::Zero(3 * remesh.vertex_count())};
  add_samples(remesh, systems, system);
  add_springs(remesh, anchors, system);
  const Eigen::VectorXd solution = solve(system, progress);
  std::vector<Vec3> positions = remesh.positions();
  if (!solution.allFinite()) return positions;
  for (int v = 0; v < remesh.vertex_count(); ++v) positions[v] += solution.segment<3>(3 * v);
  return positions;
}

}  // namespace gvd
