#include "gvd/features.hpp"

#include <cmath>
#include <numbers>

#include "crease_network.hpp"
#include "gvd/error.hpp"

namespace gvd {
namespace {

Vec3 face_normal(const Mesh& mesh, FaceId f) {
  const auto& [a, b, c] = mesh.vertices(f);
  return (mesh.position(b) - mesh.position(a)).cross(mesh.position(c) - mesh.position(a)).stableNormalized();
}

/// Places generators along the curves of a crease network, each once.
class CreasePlacer {
 public:
  CreasePlacer(const Mesh& mesh, const CreaseNetwork& network, double spacing)
      : mesh_(mesh), network_(network), spacing_(spacing), done_(static_cast<std::size_t>(mesh.edge_count()), false) {}

  FeatureGenerators run(const std::vector<EdgeId>& creases) {
    std::vector<VertexId> corners;
    for (std::int32_t v = 0; v < mesh_.vertex_count(); ++v) {
      if (network_.leaving(VertexId(v)).empty() || !network_.is_corner(VertexId(v))) continue;
      corners.emplace_back(v);
      add(vertex_point(mesh_, VertexId(v)), Freedom::fixed);
    }
    for (const VertexId v : corners) {
      for (const CreaseNetwork::Step& step : network_.leaving(v)) place_along(step);
    }
    for (const EdgeId e : creases) place_along({e, true});  // the closed ones are left
    return std::move(placed_);
  }

 private:
  void add(const SurfacePoint& point, Freedom freedom) {
    placed_.points.push_back(point);
    placed_.freedom.push_back(freedom);
  }

  /// Places generators between the ends of the curve that begins with this step.
  void place_along(const CreaseNetwork::Step& first) {
    if (done_[first.edge]) return;
    std::vector<CreaseNetwork::Step> curve;
    double length = 0;
    CreaseNetwork::Step step = first;
    for (; step.edge.valid() && !done_[step.edge]; step = network_.next(step)) {
      done_[step.edge] = true;
      curve.push_back(step);
      length += mesh_.length(mesh_.halfedge(step.edge));
    }
    const bool closed = step.edge.valid() && step.edge == first.edge && !network_.is_corner(network_.start(first));
    const double parts = std::max(std::round(length / spacing_), closed ? 3.0 : 1.0);
    double passed = 0;
    std::size_t i = 0;
    for (double k = closed ? 0 : 1; k < parts; ++k) {
      const double at = length * k / parts;
      while (i + 1 < curve.size() && passed + edge_length(curve[i]) < at) passed += edge_length(curve[i++]);
      add(network_.at(curve[i], at - passed), Freedom::on_crease);
    }
  }
  double edge_length(const CreaseNetwork::Step& step) const { return mesh_.length(mesh_.halfedge(step.edge)); }

  const Mesh& mesh_;
  const CreaseNetwork& network_;
  double spacing_;
  IdVector<EdgeId, bool> done_;
  FeatureGenerators placed_;
};

}  // namespace

std::vector<EdgeId> find_creases(const Mesh& mesh, const CreaseOptions& options) {
  if (!(options.angle > 0 && options.angle <= 180)) {
    throw Error(ErrorCode::invalid_option, "the angle of creases must be above 0 and at most 180 degrees");
  }
  const double least_cosine = options.angle == 180 ? -2 : std::cos(options.angle * std::numbers::pi / 180);
  std::vector<EdgeId> creases;
  for (std::int32_t i = 0; i < mesh.edge_count(); ++i) {
    const HalfedgeId h = mesh.halfedge(EdgeId(i)), twin = mesh.twin(h);
    if (!twin.valid()) {
      if (options.with_boundary) creases.emplace_back(i);
      continue;
    }
    const Vec3 here = face_normal(mesh, Mesh::face(h)), there = face_normal(mesh, Mesh::face(twin));
    const bool has_area = mesh.area(Mesh::face(h)) > 0 && mesh.area(Mesh::face(twin)) > 0;
    if (has_area && here.dot(there) < least_cosine) creases.emplace_back(i);
  }
  return creases;
}

std::vector<Freedom> freedoms_on_creases(const Mesh& mesh, const std::vector<EdgeId>& creases,
                                         const std::vector<SurfacePoint>& points) {
  const CreaseNetwork network(mesh, creases);
  std::vector<Freedom> freedoms;
  for (const SurfacePoint& p : points) {
    const bool is_vertex = p.kind() == SurfacePoint::Kind::vertex;
    const bool is_corner = is_vertex && network.contains(p) && network.is_corner(vertex(mesh, p));
    freedoms.push_back(is_corner ? Freedom::fixed : network.contains(p) ? Freedom::on_crease : Freedom::free);
  }
  return freedoms;
}

FeatureGenerators place_on_creases(const Mesh& mesh, const std::vector<EdgeId>& creases, double spacing) {
  if (!(spacing > 0)) throw Error(ErrorCode::invalid_option, "the spacing of generators on creases must be above 0");
  const CreaseNetwork network(mesh, creases);
  return CreasePlacer(mesh, network, spacing).run(creases);
}

}  // namespace gvd
