// Computes the density for cells that keep the mean distance of a remesh from its surface small.
//
// Triangles of side h on a surface with curvatures k1 and k2 have a mean square distance of q^2 h^4 / 1280 from it,
// with q^2 = k1^2 + k2^2 - 2/3 k1 k2. For a given number of triangles, the sum of these is least if h is proportional
// to q^(-1/3). The mean square distance of a disc of radius R from its best plane is q^2 R^4 / 64, with the same q. So
// q is measured in discs about as large as cells. Then noise and bumps much smaller than cells count little, and
// creases have a finite curvature. docs/developer/lloyd.md, section 8, has the derivations.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <queue>
#include <utility>
#include <vector>

#include "gvd/density.hpp"
#include "gvd/error.hpp"
#include "gvd/sampling.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

using VertexValues = IdVector<VertexId, double>;

/// Radius of the discs, in units of the even spacing; a disc with the area of a cell has 0.53. With smaller discs noise
/// counts, and larger discs miss details that cells can follow.
constexpr double kDiscRadius = 0.8;

/// Vertices nearer than this to the centre of a disc, in units of its radius, get no disc of their own. About 13 discs
/// then overlap at a point.
constexpr double kDiscSpacing = 0.4;

/// Discs whose distance from their plane is below this, in units of the radius, count as equally flat. Rounding gives
/// 1e-8, the root of the machine precision; a sphere with ten million generators gives 1e-4.
constexpr double kFlatDisc = 1e-5;

/// Number of rounds that scale sizes to the given number of cells, because limiting the gradation makes some sizes
/// smaller. After three rounds the number is right within 5 % on all meshes of the tests.
constexpr int kScaleRounds = 3;

/// The area and moments of triangles about the centre of a disc, with lengths in units of its radius.
struct Moments {
  double area = 0;
  Vec3 first = Vec3::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();

  void add(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double of_face = 0.5 * (b - a).cross(c - a).norm();
    const Vec3 mean = (a + b + c) / 3;
    area += of_face;
    first += of_face * mean;
    second += of_face / 12 * (a * a.transpose() + b * b.transpose() + c * c.transpose() + 9 * mean * mean.transpose());
  }

  /// q^(2/3), from the mean square distance from the best plane; 0 without area. The number of cells per area is
  /// proportional to it.
  double wanted_cells() const {
    const Vec3 mean = first / area;
    const Eigen::Matrix3d covariance = second / area - mean * mean.transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance, Eigen::EigenvaluesOnly);
    const double squared_radius = area / std::numbers::pi;
    const double squared = 64 * solver.eigenvalues()[0] / (squared_radius * squared_radius);
    return std::isfinite(squared) ? std::cbrt(std::max(0.0, squared)) : 0;
  }
};

/// Collects discs of the surface, each made of whole faces.
class Discs {
 public:
  Discs(const Mesh& mesh, double radius) : mesh_(mesh), radius_(radius), last_(mesh.face_count(), VertexId()) {}

  /// Collects the faces of a vertex and all faces connected with them whose centres are within the radius. Returns the
  /// moments of the disc.
  Moments collect(VertexId centre) {
    centre_ = centre;
    faces_.clear();
    for_each_outgoing(mesh_, centre, [&](HalfedgeId h) { add(Mesh::face(h)); });
    Moments moments;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      const auto [a, b, c] = corners(faces_[i]);
      moments.add(a, b, c);
      for (const HalfedgeId h : Mesh::halfedges(faces_[i])) {
        const HalfedgeId twin = mesh_.twin(h);
        if (twin.valid() && is_inside(Mesh::face(twin))) add(Mesh::face(twin));
      }
    }
    return moments;
  }

  /// Calls visit(vertex, its distance from the centre in units of the radius) for each corner of the last disc's faces.
  template <class Visit>
  void for_each_corner(Visit visit) const {
    for (const FaceId f : faces_) {
      for (const VertexId v : mesh_.vertices(f)) visit(v, place(v).norm());
    }
  }

 private:
  Vec3 place(VertexId v) const { return (mesh_.position(v) - mesh_.position(centre_)) / radius_; }

  std::array<Vec3, 3> corners(FaceId f) const {
    const auto& [a, b, c] = mesh_.vertices(f);
    return {place(a), place(b), place(c)};
  }

  bool is_inside(FaceId f) const {
    const auto [a, b, c] = corners(f);
    return (a + b + c).squaredNorm() <= 9;
  }

  void add(FaceId f) {
    if (last_[f] == centre_) return;
    last_[f] = centre_;
    faces_.push_back(f);
  }

  const Mesh& mesh_;
  double radius_;
  VertexId centre_;
  std::vector<FaceId> faces_;
  IdVector<FaceId, VertexId> last_;  // for each face, the centre of the last disc that contains it
};

/// q^(2/3) at the vertices: the mean over the discs there, with weights that fall to 0 at the rim of a disc.
VertexValues wanted_cells(const Mesh& mesh, double radius, const Progress& progress) {
  VertexValues sum(mesh.vertex_count(), 0), weight(mesh.vertex_count(), 0);
  IdVector<VertexId, char> is_covered(mesh.vertex_count(), 0);
  Discs discs(mesh, radius);
  for (const VertexId centre : mesh.vertices()) {
    if (is_covered[centre] != 0) continue;
    report_progress(progress, "density", double(centre.value()) / mesh.vertex_count());
    const double wanted = discs.collect(centre).wanted_cells();
    discs.for_each_corner([&](VertexId v, double distance) {
      const double share = std::max(0.0, 1 - distance * distance);
      sum[v] += share * share * wanted;
      weight[v] += share * share;
      if (distance <= kDiscSpacing) is_covered[v] = 1;
    });
  }
  for (const VertexId v : mesh.vertices()) sum[v] /= weight[v];
  return sum;
}

/// Sizes of cells from their wanted number per area, between 1 and at most `range`.
VertexValues sizes_in_range(const VertexValues& wanted, double range) {
  const double largest = *std::max_element(wanted.begin(), wanted.end());
  const double least = std::max(largest / (range * range), std::cbrt(64 * kFlatDisc * kFlatDisc));
  VertexValues sizes;
  for (const double cells : wanted) sizes.push_back(std::sqrt(std::max(largest, least) / std::max(cells, least)));
  return sizes;
}

/// Lowers sizes in the manner of Dijkstra's algorithm, until no size exceeds a neighbour's by more than the gradation
/// allows.
void limit_gradation(const Mesh& mesh, double gradation, VertexValues& sizes) {
  using Item = std::pair<double, VertexId>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  for (const VertexId v : mesh.vertices()) queue.emplace(sizes[v], v);
  while (!queue.empty()) {
    const auto [size, v] = queue.top();
    queue.pop();
    if (size > sizes[v]) continue;
    for_each_neighbour(mesh, v, [&, size = size](VertexId w, HalfedgeId h) {
      const double most = size + gradation * mesh.length(h);
      if (!(most < sizes[w])) return;
      sizes[w] = most;
      queue.emplace(most, w);
    });
  }
}

/// The mean of size^-2 over the area: the number of cells of these sizes, divided by the number of cells of size 1.
double mean_inverse_square(const Mesh& mesh, const VertexValues& sizes) {
  double sum = 0, area = 0;
  for (const FaceId f : mesh.faces()) {
    for (const VertexId v : mesh.vertices(f)) sum += mesh.area(f) / (3 * sizes[v] * sizes[v]);
    area += mesh.area(f);
  }
  return sum / area;
}

void check_options(std::int64_t count, const CurvatureDensityOptions& options) {
  const auto refuse = [](const char* message) { throw Error(ErrorCode::invalid_option, message); };
  if (count < 1) refuse("the number of generators must be 1 or more");
  if (!(options.gradation > 0) || !std::isfinite(options.gradation)) refuse("the gradation must be above 0");
  if (!(options.range >= 1) || !std::isfinite(options.range)) refuse("the range of sizes must be 1 or more");
}

}  // namespace

Density make_curvature_density(const Mesh& mesh, std::int64_t count, const CurvatureDensityOptions& options) {
  check_options(count, options);
  const double spacing = even_spacing(compute_area(mesh), count);
  if (!(spacing > 0) || !std::isfinite(spacing)) return {};
  const VertexValues best = sizes_in_range(wanted_cells(mesh, kDiscRadius * spacing, options.progress), options.range);
  VertexValues sizes = best;
  double scale = 1;
  for (int round = 0; round < kScaleRounds; ++round) {
    scale *= std::sqrt(mean_inverse_square(mesh, sizes));
    for (const VertexId v : mesh.vertices()) sizes[v] = scale * best[v];
    limit_gradation(mesh, options.gradation / spacing, sizes);
  }
  std::vector<double> values;
  for (const double size : sizes) values.push_back(std::pow(size, -4));
  return make_vertex_density(mesh, values);
}

}  // namespace gvd
