// The marched distances as a DistanceField, for the envelope tracer.
//
// Idea: the distances of a generator at the two ends of a side determine its image beyond that side, if they come from
// a point. So the table of each face becomes three images for each generator.
// Source: section 4.1 of the paper, with the circle front in place of its linear one.
// Invariant: an image has the two distances that it was unfolded from, and its paths enter through the side between.
#include "geodesic/marching/marched_distances.hpp"

#include <tuple>

#include "base/plane.hpp"
#include "geodesic/marching/unfold.hpp"

namespace gvd {

const VertexDistance& MarchedDistances::nearest(VertexId v) const {
  const VertexDistance* best = &table_.distance(v.value());
  table_.for_each(v, [&](const VertexDistance& d) {
    if (std::tie(d.distance, d.generator) < std::tie(best->distance, best->generator)) best = &d;
  });
  return *best;
}

std::vector<EdgeId> MarchedDistances::contested_edges(const ParallelChunks& parallel) const {
  const auto has_several = [&](HalfedgeId h) {
    const FaceId f = Mesh::face(h);
    return table_.reached(f) && table_.entry(f.value()).next >= 0;
  };
  return find_edges(mesh_, parallel, [&](EdgeId e) {
    const HalfedgeId h = mesh_.halfedge(e), twin = mesh_.twin(h);
    return has_several(h) || (twin.valid() && has_several(twin));
  });
}

void MarchedDistances::collect(EdgeId e, std::vector<EdgeSource>& sources) const {
  sources.clear();
  const HalfedgeId h = mesh_.halfedge(e);
  const double length = mesh_.length(h);
  const VertexDistance &from = nearest(mesh_.from(h)), &to = nearest(mesh_.to(h));
  sources.push_back({0, length, 0, 0, from.distance, from.generator});
  sources.push_back({0, length, length, 0, to.distance, to.generator});
  for (const HalfedgeId side : {h, mesh_.twin(h)}) {
    if (!side.valid()) continue;
    table_.for_each(Mesh::face(side), [&](const TableEntry& entry) {
      if (entry.dominated) return;
      const auto d = table_.corner_distances(entry);
      const int i = Mesh::corner(side), j = (i + 1) % 3;
      const double a = side == h ? d[i] : d[j], b = side == h ? d[j] : d[i];
      const double x = apex_foot(length, a, b);
      // Distances that break the triangle inequality have no image: only the paths along the edge remain.
      if (std::abs(x) <= a) sources.push_back({0, length, x, std::sqrt((a - x) * (a + x)), 0, entry.generator});
    });
  }
}

void MarchedDistances::collect(FaceId f, const FaceLayout& layout, std::vector<FaceSource>& sources) const {
  sources.clear();
  const auto& corner = layout.corner;
  for (int i = 0; i < 3; ++i) {
    const VertexDistance& v = nearest(mesh_.vertices(f)[i]);
    sources.push_back(
        {corner[i], corner[i], corner[i], v.distance, v.generator, Mesh::halfedge(f, i), true, v.distance, v.distance});
  }
  table_.for_each(f, [&](const TableEntry& entry) {
    const auto d = table_.corner_distances(entry);
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const Vec2 image = unfold_source(corner[i], corner[j], d[i], d[j]);
      sources.push_back({image, corner[i], corner[j], 0, entry.generator, Mesh::halfedge(f, i), false, d[i], d[j]});
    }
  });
}

}  // namespace gvd
