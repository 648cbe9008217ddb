#include "geodesic/window_distances.hpp"

namespace gvd {
namespace {

EdgeSource along(const KeptWindow& w) {
  return {w.begin, w.end, w.x, w.depth, w.offset, GeneratorId(w.generator)};
}

/// The same window, seen along the edge's other halfedge.
EdgeSource against(const KeptWindow& w, double length) {
  return {length - w.end, length - w.begin, length - w.x, w.depth, w.offset, GeneratorId(w.generator)};
}

}  // namespace

std::vector<EdgeId> WindowDistances::contested_edges() const {
  std::vector<char> contested(static_cast<std::size_t>(mesh_.edge_count()), 0);
  for (std::int32_t i = 0; i < mesh_.face_count(); ++i) {
    for (const KeptWindow& w : field_.windows.in(FaceId(i))) {
      const HalfedgeId h(w.halfedge);
      if (field_.label[mesh_.from(h)] != w.generator || field_.label[mesh_.to(h)] != w.generator) {
        contested[mesh_.edge(h).index()] = 1;
      }
    }
  }
  std::vector<EdgeId> edges;
  for (std::int32_t i = 0; i < mesh_.edge_count(); ++i) {
    const HalfedgeId h = mesh_.halfedge(EdgeId(i));
    if (contested[EdgeId(i).index()] != 0 || field_.label[mesh_.from(h)] != field_.label[mesh_.to(h)]) {
      edges.push_back(EdgeId(i));
    }
  }
  return edges;
}

void WindowDistances::collect(EdgeId e, std::vector<EdgeSource>& sources) const {
  sources.clear();
  const HalfedgeId h = mesh_.halfedge(e), twin = mesh_.twin(h);
  const double length = mesh_.length(h);
  const VertexId a = mesh_.from(h), b = mesh_.to(h);
  sources.push_back({0, length, 0, 0, field_.distance[a], GeneratorId(field_.label[a])});
  sources.push_back({0, length, length, 0, field_.distance[b], GeneratorId(field_.label[b])});
  // On the boundary a window's frame is that of the missing twin.
  for (const KeptWindow& w : field_.windows.on(h)) sources.push_back(twin.valid() ? along(w) : against(w, length));
  if (!twin.valid()) return;
  for (const KeptWindow& w : field_.windows.on(twin)) sources.push_back(against(w, length));
}

void WindowDistances::collect(FaceId f, const std::array<Vec2, 3>& corner, std::vector<FaceSource>& sources) const {
  sources.clear();
  for (std::size_t i = 0; i < 3; ++i) {
    const VertexId v = mesh_.vertices(f)[i];
    const double d = field_.distance[v];
    sources.push_back({GeneratorId(field_.label[v]), corner[i], corner[i], corner[i], d, d, d, 3 + static_cast<int>(i)});
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const HalfedgeId h = Mesh::halfedge(f, static_cast<int>(i));
    if (!mesh_.twin(h).valid()) continue;  // windows that end there
    const Vec2 unit = (corner[(i + 1) % 3] - corner[i]) / mesh_.length(h);
    const Vec2 outward(unit.y(), -unit.x());
    for (const KeptWindow& w : field_.windows.on(h)) {
      sources.push_back({GeneratorId(w.generator), corner[i] + w.x * unit + w.depth * outward, corner[i] + w.begin * unit,
                         corner[i] + w.end * unit, w.offset, w.distance(w.begin), w.distance(w.end), static_cast<int>(i)});
    }
  }
}

}  // namespace gvd
