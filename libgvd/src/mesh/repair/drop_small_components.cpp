// Components of a checked mesh that are too small are left out, by the diagonals of their bounding boxes.
//
// A component is left out as a whole, so what remains needs no repair. The tables from and to the input lose its rows.
#include "gvd/drop_small_components.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <utility>

#include "gvd/error.hpp"
#include "gvd/text.hpp"
#include "mesh/submesh.hpp"

namespace gvd {
namespace {

struct ComponentSize {
  FaceId first_face;
  Eigen::AlignedBox3d box;
  double area = 0;  // square mesh units

  double diagonal() const { return box.diagonal().stableNorm(); }
};

/// In the order of the components' numbers.
std::vector<ComponentSize> measure_components(const Mesh& mesh, const IdVector<FaceId, std::int32_t>& component) {
  std::vector<ComponentSize> sizes(component.empty() ? 0 : 1 + *std::max_element(component.begin(), component.end()));
  for (const FaceId f : mesh.faces()) {
    ComponentSize& size = sizes[component[f]];
    if (!size.first_face.valid()) size.first_face = f;
    for (const VertexId v : mesh.vertices(f)) size.box.extend(mesh.position(v));
    size.area += mesh.shape(f).twice_area / 2;
  }
  return sizes;
}

/// Leaves out the faces that are not kept, and the vertices that only they have.
void keep_faces(CheckedMesh& checked, const std::vector<FaceId>& kept_faces) {
  const Mesh& mesh = checked.mesh;
  std::vector<std::array<VertexId, 3>> faces;
  IdVector<FaceId, std::int32_t> polygons;
  Appearance& look = checked.appearance;
  std::vector<Uv> texture;
  std::vector<std::int32_t> material;
  for (const FaceId f : kept_faces) {
    faces.push_back(mesh.vertices(f));
    polygons.push_back(checked.input_polygon[f]);
    if (!look.material.empty()) material.push_back(look.material[f.index()]);
    if (look.texture.empty()) continue;
    for (std::size_t i = 3 * f.index(); i < 3 * f.index() + 3; ++i) texture.push_back(look.texture[i]);
  }
  const KeptVertices kept = drop_unused_vertices(std::size_t(mesh.vertex_count()), faces);
  std::vector<Vec3> positions;
  IdVector<VertexId, std::int32_t> input_vertex;
  for (const VertexId v : kept.before) {
    positions.push_back(mesh.position(v));
    input_vertex.push_back(checked.input_vertex[v]);
  }
  for (VertexId& v : checked.mesh_vertex) v = v.valid() ? kept.after[v] : v;
  look.texture = std::move(texture);
  look.material = std::move(material);
  checked.input_vertex = std::move(input_vertex);
  checked.input_polygon = std::move(polygons);
  checked.mesh = Mesh(std::move(positions), std::move(faces));
}

}  // namespace

void drop_small_components(CheckedMesh& checked, const ErrorBound& bound) {
  const double size = bound.in_diagonals ? bound.value * checked.mesh.bbox_diagonal() : bound.value;
  const auto component = compute_face_components(checked.mesh);
  const std::vector<ComponentSize> sizes = measure_components(checked.mesh, component);
  const auto is_small = [&](const ComponentSize& one) { return one.diagonal() < size; };
  const std::int64_t count = std::count_if(sizes.begin(), sizes.end(), is_small);
  DefectReport& report = checked.defects;
  if (count == 0) {
    report.messages.push_back(fmt::format("no component is smaller than {:.6g}: none is left out", size));
    return;
  }
  if (count == std::ssize(sizes)) {
    double largest = 0;
    for (const ComponentSize& one : sizes) largest = std::max(largest, one.diagonal());
    throw Error(ErrorCode::precondition,
                fmt::format("all components are smaller than {:.6g}, the largest one {:.6g} across: give less with "
                            "\1drop_smaller_than\2",
                            size, largest));
  }
  double area = 0, dropped = 0;
  for (const ComponentSize& one : sizes) (is_small(one) ? dropped : area) += one.area;
  std::vector<FaceId> kept;
  for (const FaceId f : checked.mesh.faces()) {
    if (!is_small(sizes[component[f]])) kept.push_back(f);
  }
  const FaceId first = std::find_if(sizes.begin(), sizes.end(), is_small)->first_face;
  const std::int64_t polygon = checked.input_polygon[first];
  Defect defect{
      DefectKind::dropped_components, count, polygon,
      fmt::format("{} smaller than {:.6g}, first the one of face {}: left out, with {:.3g} % of the area",
                  counted(count, "component is", "components are"), size, polygon, 100 * dropped / (area + dropped))};
  keep_faces(checked, kept);
  report.messages.push_back(defect.message);
  report.defects.push_back(std::move(defect));
}

}  // namespace gvd
