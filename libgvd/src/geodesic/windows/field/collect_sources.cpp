#include "geodesic/windows/field/collect_sources.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace gvd {

void collect_edge_sources(const Mesh& mesh, const WindowField& field, HalfedgeId h, std::vector<EdgeSource>& sources) {
  sources.clear();
  const double length = mesh.length(h);
  const VertexId from = mesh.from(h), to = mesh.to(h);
  if (field.label[from].valid()) sources.push_back({0, length, 0, 0, field.distance[from], field.label[from]});
  if (field.label[to].valid()) sources.push_back({0, length, length, 0, field.distance[to], field.label[to]});
  const HalfedgeId twin = mesh.twin(h);
  const auto mirrored = [&](const Window& w) {
    sources.push_back({length - w.end, length - w.begin, length - w.x, w.depth, w.offset, w.generator});
  };
  if (twin.valid()) {
    field.windows.for_each(h, [&](const Window& w) {
      sources.push_back({w.begin, w.end, w.x, w.depth, w.offset, w.generator});
    });
    field.windows.for_each(twin, mirrored);
  } else {
    field.windows.for_each(h, mirrored);
  }
}

void collect_face_sources(const Mesh& mesh, const WindowField& field, FaceId f, const FaceLayout& layout,
                          std::vector<FaceSource>& sources) {
  sources.clear();
  const std::array<Vec2, 3> side{layout.side(0), layout.side(1), layout.side(2)};
  field.windows.for_each(f, [&](const Window& w) {
    const HalfedgeId h = w.halfedge;
    if (!mesh.twin(h).valid()) return;  // the boundary: the paths leave the face
    const int i = Mesh::corner(h);
    const Vec2 origin = layout.corner[i], along = side[i], inwards(-along.y(), along.x());
    const Vec2 image = origin + w.x * along - w.depth * inwards;
    sources.push_back({image, origin + w.begin * along, origin + w.end * along, w.offset, w.generator, h, false,
                       w.distance(w.begin), w.distance(w.end)});
  });
  for (int i = 0; i < 3; ++i) {
    const VertexId v = mesh.vertices(f)[i];
    if (!field.label[v].valid()) continue;
    const Vec2 at = layout.corner[i];
    const double d = field.distance[v];
    sources.push_back({at, at, at, d, field.label[v], Mesh::halfedge(f, i), true, d, d});
  }
}

}  // namespace gvd
