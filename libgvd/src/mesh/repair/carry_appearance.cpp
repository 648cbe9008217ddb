// Carries the texture coordinates and materials of a soup to the faces that its polygons became.
//
// The repair handles only vertices, so that a texture costs nothing on meshes that have none. Afterwards each corner of
// a face is matched by its vertex to a corner of its polygon. Welded and copied vertices are identified by the vertex
// of the mesh that the first of them became.
// Invariant: a corner has the texture coordinates of a corner of its own polygon, bit by bit, so that seams stay seams.

#include "mesh/repair/carry_appearance.hpp"

#include "base/plane.hpp"

namespace gvd {
namespace {

/// The texture coordinates of a polygon's corner at v; of the first corner if there are several.
Uv texture_at_vertex(const PolygonSoup& soup, const CheckedMesh& checked, std::size_t polygon, VertexId v) {
  const std::int32_t vertex = checked.input_vertex[v];
  for (std::size_t c = soup.first_corner[polygon]; c < soup.first_corner[polygon + 1]; ++c) {
    const std::int32_t other = soup.corners[c];
    if (other == vertex || checked.mesh_vertex[other] == checked.mesh_vertex[vertex]) return soup.appearance.texture[c];
  }
  return kNoTexture;
}

/// The texture coordinates at the midpoint of a split edge or diagonal of the polygon: interpolated on the edge or
/// diagonal on which the midpoint lies.
Uv texture_at_midpoint(const PolygonSoup& soup, const CheckedMesh& checked, std::size_t polygon, const Vec3& midpoint) {
  const auto vertex = [&](std::size_t corner) { return std::size_t(soup.corners[corner]); };
  Uv found = kNoTexture;
  double nearest = kInfinity;
  for (std::size_t a = soup.first_corner[polygon]; a < soup.first_corner[polygon + 1]; ++a) {
    for (std::size_t b = soup.first_corner[polygon]; b < soup.first_corner[polygon + 1]; ++b) {
      // Takes the edge in the same direction in both of its faces.
      if (!(checked.mesh_vertex[vertex(a)] < checked.mesh_vertex[vertex(b)])) continue;
      const Vec3 &from = soup.positions[vertex(a)], along = soup.positions[vertex(b)] - from;
      const double t = nearest_on_segment(from, along, midpoint);
      const double distance = (from + t * along - midpoint).norm();
      if (!(distance < nearest)) continue;
      nearest = distance;
      const Uv &uv_a = soup.appearance.texture[a], &uv_b = soup.appearance.texture[b];
      for (std::size_t k = 0; k < 2; ++k) found[k] = (1 - t) * uv_a[k] + t * uv_b[k];
    }
  }
  return found;
}

}  // namespace

Appearance carry_appearance(const PolygonSoup& soup, const CheckedMesh& checked) {
  const Appearance& given = soup.appearance;
  Appearance carried{{}, {}, given.materials, given.material_files, given.unread};
  if (!given.texture.empty()) {
    carried.texture.reserve(std::size_t(checked.mesh.halfedge_count()));
    for (const FaceId f : checked.mesh.faces()) {
      const auto polygon = std::size_t(checked.input_polygon[f]);
      for (const VertexId v : checked.mesh.vertices(f)) {
        const bool is_midpoint = checked.input_vertex[v] < 0;
        carried.texture.push_back(is_midpoint ? texture_at_midpoint(soup, checked, polygon, checked.mesh.position(v))
                                              : texture_at_vertex(soup, checked, polygon, v));
      }
    }
  }
  if (given.material.empty()) return carried;
  for (const std::int32_t polygon : checked.input_polygon) {
    carried.material.push_back(given.material[std::size_t(polygon)]);
  }
  return carried;
}

}  // namespace gvd
