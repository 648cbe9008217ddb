// Diagrams from distances of one's own: shortest paths along edges, and geodesics in heat.
//
//   own_distances MESH [GENERATORS]
//
// Prints for each the share of vertices with the label of the exact diagram.
// Heat: Crane, Weischedel and Wardetzky, Geodesics in Heat, ACM Transactions on Graphics 32 (2013).
#include <Eigen/Sparse>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <functional>
#include <gvd/check.hpp>
#include <gvd/read_soup.hpp>
#include <gvd/sampling.hpp>
#include <gvd/soup.hpp>
#include <gvd/trace_diagram.hpp>
#include <queue>
#include <string>
#include <utility>
#include <vector>

namespace {

using gvd::Vec3;

/// Lengths of the shortest paths along edges, by Dijkstra's algorithm.
class EdgePaths {
 public:
  explicit EdgePaths(const gvd::Mesh& mesh) : mesh_(mesh), neighbours_(mesh.vertex_count()) {
    for (const gvd::EdgeId e : mesh.edges()) {
      const gvd::HalfedgeId h = mesh.halfedge(e);
      neighbours_[mesh.from(h)].emplace_back(mesh.length(h), mesh.to(h));
      neighbours_[mesh.to(h)].emplace_back(mesh.length(h), mesh.from(h));
    }
  }

  /// Fills in one row. A generator inside a face begins at the face's corners.
  void solve(const gvd::SurfacePoint& source, std::span<double> row) const {
    using Reached = std::pair<double, gvd::VertexId>;
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> queue;
    const Vec3 start = gvd::position(mesh_, source);
    for (const gvd::VertexId v : mesh_.vertices(source.face)) queue.emplace((mesh_.position(v) - start).norm(), v);
    while (!queue.empty()) {
      const auto [distance, v] = queue.top();
      queue.pop();
      if (row[v.index()] <= distance) continue;  // a row begins with infinity everywhere
      row[v.index()] = distance;
      for (const auto& [length, u] : neighbours_[v]) queue.emplace(distance + length, u);
    }
  }

 private:
  const gvd::Mesh& mesh_;
  gvd::IdVector<gvd::VertexId, std::vector<std::pair<double, gvd::VertexId>>> neighbours_;
};

/// Distances from the direction in which heat flows. Both matrices are factorized once, for all generators.
class HeatDistances {
 public:
  explicit HeatDistances(const gvd::Mesh& mesh) : mesh_(mesh) {
    const int n = mesh.vertex_count();
    std::vector<Eigen::Triplet<double>> stiffness, mass;
    for (const gvd::FaceId f : mesh.faces()) add_face(f, stiffness, mass);
    Eigen::SparseMatrix<double> l(n, n), m(n, n);
    l.setFromTriplets(stiffness.begin(), stiffness.end());
    m.setFromTriplets(mass.begin(), mass.end());
    const double time = mesh.mean_edge_length() * mesh.mean_edge_length();
    flow_.compute(m + time * l);
    poisson_.compute(l + 1e-9 * m / time);  // a little mass makes it invertible
  }

  void solve(const gvd::SurfacePoint& source, std::span<double> row) const {
    Eigen::VectorXd heat = Eigen::VectorXd::Zero(mesh_.vertex_count());
    const auto& corners = mesh_.vertices(source.face);
    for (std::size_t i = 0; i < 3; ++i) heat[corners[i].value()] += source.bary[i];
    heat = flow_.solve(heat).eval();
    Eigen::VectorXd distance = poisson_.solve(divergence(heat));
    // The distance is 0 at the source. Below that is the error of the method.
    double at_source = 0;
    for (std::size_t i = 0; i < 3; ++i) at_source += source.bary[i] * distance[corners[i].value()];
    for (std::size_t v = 0; v < row.size(); ++v) row[v] = std::max(0.0, distance[Eigen::Index(v)] - at_source);
  }

 private:
  /// The side opposite corner i of f, from corner i + 1 to corner i + 2.
  Vec3 side(gvd::FaceId f, std::size_t i) const {
    const auto& v = mesh_.vertices(f);
    return mesh_.position(v[(i + 2) % 3]) - mesh_.position(v[(i + 1) % 3]);
  }

  /// The cotangent weights of the sides of f, and a third of its area at each corner.
  void add_face(gvd::FaceId f, std::vector<Eigen::Triplet<double>>& stiffness,
                std::vector<Eigen::Triplet<double>>& mass) const {
    const double twice_area = side(f, 0).cross(side(f, 1)).norm();
    const auto& v = mesh_.vertices(f);
    for (std::size_t i = 0; i < 3; ++i) {
      const int a = v[(i + 1) % 3].value(), b = v[(i + 2) % 3].value();
      const double weight = twice_area > 0 ? -0.5 * side(f, (i + 1) % 3).dot(side(f, (i + 2) % 3)) / twice_area : 0;
      stiffness.insert(stiffness.end(), {{a, a, weight}, {b, b, weight}, {a, b, -weight}, {b, a, -weight}});
      mass.emplace_back(v[i].value(), v[i].value(), twice_area / 6);
    }
  }

  /// Divergence of the unit field against the heat's gradient.
  Eigen::VectorXd divergence(const Eigen::VectorXd& heat) const {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(heat.size());
    for (const gvd::FaceId f : mesh_.faces()) {
      const auto& v = mesh_.vertices(f);
      const Vec3 normal = side(f, 0).cross(side(f, 1));
      Vec3 gradient = Vec3::Zero();
      for (std::size_t i = 0; i < 3; ++i) gradient += heat[v[i].value()] * normal.cross(side(f, i));
      const double length = gradient.norm(), twice_area = normal.norm();
      if (!(length > 0) || !(twice_area > 0)) continue;  // no heat came here
      const Vec3 flow = -gradient / length;
      // Half of each side's cotangent times the flow along it, at both of its ends; L is positive, so the sign turns.
      for (std::size_t i = 0; i < 3; ++i) {
        const double along = -0.5 * side(f, (i + 1) % 3).dot(side(f, (i + 2) % 3)) / twice_area * side(f, i).dot(flow);
        result[v[(i + 1) % 3].value()] -= along;
        result[v[(i + 2) % 3].value()] += along;
      }
    }
    return result;
  }

  const gvd::Mesh& mesh_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> flow_, poisson_;
};

/// Prints how a diagram compares with the exact one. Returns whether it passes its check.
bool report(const char* name, const gvd::Mesh& mesh, const gvd::Diagram& diagram, const gvd::Diagram& exact) {
  int same = 0;
  for (const gvd::VertexId v : mesh.vertices()) same += diagram.vertex_label[v] == exact.vertex_label[v];
  const gvd::DiagramCheck check = gvd::check_diagram(mesh, diagram);
  std::printf("%s: %zu bisectors of length %.4g, %.1f %% of the labels are exact, %s\n", name, diagram.bisectors.size(),
              diagram.length, 100.0 * same / mesh.vertex_count(), check.ok() ? "complete" : "NOT SOUND");
  return check.ok();
}

int run(const gvd::Mesh& mesh, std::int32_t count) {
  gvd::SamplingOptions sampling;
  sampling.kind = gvd::Sampling::farthest;
  sampling.count = count;
  const std::vector<gvd::SurfacePoint> generators = gvd::sample_generators(mesh, sampling);
  const gvd::Diagram exact = gvd::compute_diagram(mesh, generators);

  // As a callback: one row at a time, so that memory does not grow with the number of generators.
  const EdgePaths paths(mesh);
  const gvd::Diagram by_paths = gvd::trace_diagram(
      mesh, generators, [&](gvd::GeneratorId g, std::span<double> row) { paths.solve(generators[g.index()], row); });

  // As an array of all distances, generator by generator.
  const HeatDistances heat(mesh);
  const std::size_t n = static_cast<std::size_t>(mesh.vertex_count());
  std::vector<double> distances(generators.size() * n);
  for (std::size_t g = 0; g < generators.size(); ++g) {
    heat.solve(generators[g], std::span(distances).subspan(g * n, n));
  }
  const gvd::Diagram by_heat = gvd::trace_diagram(mesh, generators, distances);

  const bool paths_are_sound = report("edge paths", mesh, by_paths, exact);
  const bool heat_is_sound = report("heat", mesh, by_heat, exact);
  return paths_are_sound && heat_is_sound ? 0 : 1;
}

}  // namespace

int main(int argc, char* argv[]) {
  if (argc < 2 || argc > 3) return std::fprintf(stderr, "usage: %s MESH [GENERATORS]\n", argv[0]), 2;
  try {
    return run(gvd::build_mesh(gvd::read_soup(argv[1])).mesh, argc == 3 ? std::stoi(argv[2]) : 12);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
