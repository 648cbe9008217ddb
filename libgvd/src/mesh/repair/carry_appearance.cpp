// Texture coordinates and materials of a soup, on the faces that its polygons became.
//
// The repair knows vertices alone, so that meshes without a texture cost nothing. Afterwards each corner of a face
// looks for its vertex among the corners of its polygon: welded and copied vertices are known by the vertex of the mesh
// that the first of them became. Invariant: a corner has the texture coordinates of a corner of its own polygon, bit by
// bit, so that seams stay seams.

#include "mesh/repair/carry_appearance.hpp"

#include "base/plane.hpp"

namespace gvd {
namespace {

class TextureCarrier {
 public:
  TextureCarrier(const PolygonSoup& soup, const CheckedMesh& checked) : soup_(soup), checked_(checked) {}

  /// In the order of the faces' corners.
  std::vector<Uv> run() const {
    std::vector<Uv> carried;
    carried.reserve(std::size_t(checked_.mesh.halfedge_count()));
    for (const FaceId f : checked_.mesh.faces()) {
      for (const VertexId v : checked_.mesh.vertices(f)) {
        const bool is_midpoint = checked_.input_vertex[v] < 0;
        const auto polygon = std::size_t(checked_.input_polygon[f]);
        carried.push_back(is_midpoint ? at_midpoint(polygon, checked_.mesh.position(v)) : at_vertex(polygon, v));
      }
    }
    return carried;
  }

 private:
  /// The texture coordinates of the polygon's corner at v: of the first one if there are several.
  Uv at_vertex(std::size_t polygon, VertexId v) const {
    const std::int32_t vertex = checked_.input_vertex[v];
    for (std::size_t c = soup_.first_corner[polygon]; c < soup_.first_corner[polygon + 1]; ++c) {
      const std::int32_t other = soup_.corners[c];
      if (other == vertex || checked_.mesh_vertex[other] == checked_.mesh_vertex[vertex]) return texture(c);
    }
    return kNoTexture;
  }

  /// An edge or a diagonal of the polygon was split: the one on which the midpoint lies.
  Uv at_midpoint(std::size_t polygon, const Vec3& midpoint) const {
    Uv found = kNoTexture;
    double nearest = kInfinity;
    for (std::size_t a = soup_.first_corner[polygon]; a < soup_.first_corner[polygon + 1]; ++a) {
      for (std::size_t b = soup_.first_corner[polygon]; b < soup_.first_corner[polygon + 1]; ++b) {
        if (!(mesh_vertex(a) < mesh_vertex(b))) continue;  // one direction in both faces of the edge
        const Vec3 &from = position(a), along = position(b) - from;
        const double t = nearest_on_segment(from, along, midpoint);
        const double distance = (from + t * along - midpoint).norm();
        if (!(distance < nearest)) continue;
        nearest = distance;
        for (std::size_t k = 0; k < 2; ++k) found[k] = (1 - t) * texture(a)[k] + t * texture(b)[k];
      }
    }
    return found;
  }

  const Uv& texture(std::size_t corner) const { return soup_.appearance.texture[corner]; }
  const Vec3& position(std::size_t corner) const { return soup_.positions[std::size_t(soup_.corners[corner])]; }
  VertexId mesh_vertex(std::size_t corner) const { return checked_.mesh_vertex[std::size_t(soup_.corners[corner])]; }

  const PolygonSoup& soup_;
  const CheckedMesh& checked_;
};

}  // namespace

Appearance carry_appearance(const PolygonSoup& soup, const CheckedMesh& checked) {
  const Appearance& given = soup.appearance;
  Appearance carried{{}, {}, given.materials, given.material_files, given.unread};
  if (!given.texture.empty()) carried.texture = TextureCarrier(soup, checked).run();
  if (given.material.empty()) return carried;
  for (const std::int32_t polygon : checked.input_polygon) {
    carried.material.push_back(given.material[std::size_t(polygon)]);
  }
  return carried;
}

}  // namespace gvd
