// Collects the elements of an output that several formats share: regions, bisectors as polylines, and vertices with
// normals.
//
// A renderer needs a vertex once for every normal. So the ring of faces around a vertex is split at creases, where the
// normal changes, and at borders between regions and seams of a texture, where it does not, so that shading continues
// across them.
// Invariant: the order of regions, lines and vertices depends on the mesh alone, so that all formats agree and the same
// input gives the same bytes.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <span>
#include <utility>

#include "gvd/error.hpp"
#include "gvd/surface_point.hpp"
#include "io/writers/format_writers.hpp"
#include "mesh/creases.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd::io {
namespace {

/// Faces at a larger angle meet in a crease, in degrees. As on the page of --view, curved surfaces then look smooth and
/// creases sharp.
constexpr double kShadingAngle = 40;
constexpr std::uint32_t kUnseen = std::numeric_limits<std::uint32_t>::max();

/// The texture coordinates of a corner. Corners of faces without texture get 0, because GLB needs coordinates for every
/// vertex.
Uv texture_of(const LabelledMesh& labelled, HalfedgeId h) {
  if (!labelled.has_texture()) return {};
  const std::vector<Uv>& texture = labelled.appearance->texture;
  for (const HalfedgeId corner : Mesh::halfedges(Mesh::face(h))) {
    if (!fits_floats(texture[corner.index()])) return {};
  }
  return texture[h.index()];
}

/// The mean of the faces' normals at a vertex, weighted by their angles. `ring`: the halfedges that leave the vertex.
Eigen::Vector3f mean_normal(const Mesh& mesh, const IdVector<FaceId, Vec3>& normal, std::span<const HalfedgeId> ring) {
  Vec3 sum = Vec3::Zero();
  for (const HalfedgeId h : ring) sum += corner_angle(mesh, h) * normal[Mesh::face(h)];
  const Vec3 unit = sum.stableNormalized();
  return unit.isZero(0) ? Eigen::Vector3f(0, 0, 1) : Eigen::Vector3f(unit.cast<float>());
}

/// Numbers vertices in the order in which the faces use them. `of_corner`: the vertex of each corner.
ShadingVertices number_by_use(const std::vector<ShadingVertex>& vertices,
                              const IdVector<HalfedgeId, std::uint32_t>& of_corner) {
  ShadingVertices numbered;
  std::vector<std::uint32_t> number(vertices.size(), kUnseen);
  for (const std::uint32_t vertex : of_corner) {
    std::uint32_t& known = number[vertex];
    if (known == kUnseen) {
      known = std::uint32_t(numbered.vertices.size());
      numbered.vertices.push_back(vertices[vertex]);
    }
    numbered.of_corner.push_back(known);
  }
  return numbered;
}

/// Rotates a closed ring so that it begins after a break. Returns false if there is no break.
template <class IsBreak>
bool begin_at_break(std::vector<HalfedgeId>& ring, const IsBreak& is_break) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (!is_break(ring[(i + ring.size() - 1) % ring.size()], ring[i])) continue;
    std::rotate(ring.begin(), ring.begin() + i, ring.end());
    return true;
  }
  return false;
}

}  // namespace

std::vector<Region> collect_regions(const LabelledMesh& mesh) {
  // As an unsigned number the invalid label -1 is the largest, so it comes last.
  std::map<std::uint32_t, Region> regions;
  for (const FaceId f : mesh.mesh.faces()) {
    const GeneratorId label = mesh.face_label != nullptr ? (*mesh.face_label)[f] : GeneratorId();
    Region& region = regions[std::uint32_t(label.value())];
    region.label = label;
    region.faces.push_back(f);
  }
  std::vector<Region> result;
  for (auto& [label, region] : regions) result.push_back(std::move(region));
  return result;
}

std::string region_name(GeneratorId label) {
  return label.valid() ? fmt::format("region_{}", label.value()) : "unlabelled";
}

namespace {

void collect_bisectors(const LabelledMesh& mesh, std::vector<OutputLine>& lines) {
  const IdVector<VertexId, double>& distance = mesh.diagram->vertex_distance;
  const Mesh& surface = mesh.surface();
  for (const Bisector& bisector : mesh.diagram->bisectors) {
    if (bisector.points.size() < 2) continue;
    OutputLine& line = lines.emplace_back();
    line.group = "bisectors";
    line.left = bisector.left;
    line.right = bisector.right;
    const auto add = [&](const SurfacePoint& point) {
      line.points.push_back(position(surface, point));
      line.distance.push_back(distance.empty() ? kInfinity : interpolate_at(surface, distance, point));
    };
    for (const SurfacePoint& point : bisector.points) add(point);
    if (bisector.closed) add(bisector.points.front());
  }
}

}  // namespace

std::vector<OutputLine> collect_lines(const LabelledMesh& mesh) {
  std::vector<OutputLine> lines;
  if (mesh.diagram != nullptr && !mesh.no_bisectors) collect_bisectors(mesh, lines);
  if (mesh.curves == nullptr) return lines;
  for (const MeshCurve& curve : *mesh.curves) lines.push_back({{}, {}, curve.name, curve.points, curve.distance});
  return lines;
}

std::vector<NumberedLabel> number_labels(const ColoredMesh& mesh, std::string_view format) {
  if (mesh.vertex_label == nullptr) {
    throw Error(ErrorCode::invalid_option,
                fmt::format("{} holds labels of vertices, and there are none; choose another format", format));
  }
  std::vector<NumberedLabel> table{{0, "???", kUnlabelledColor}};
  for (std::size_t i = 0; i < mesh.colors.size(); ++i) {
    table.push_back({label_number(GeneratorId(i)), region_name(GeneratorId(i)), mesh.colors[i]});
  }
  return table;
}

std::array<double, 3> to_linear(const Rgb& color) {
  const auto linear = [](std::uint8_t channel) {
    const double c = channel / 255.0;
    return std::round(1e4 * (c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4))) / 1e4;
  };
  return {linear(color.red), linear(color.green), linear(color.blue)};
}

DistanceTable require_distances(const ColoredMesh& mesh, std::string_view format) {
  if (mesh.vertex_distance != nullptr) return {.rows = {mesh.vertex_distance->raw()}};
  throw Error(ErrorCode::invalid_option,
              fmt::format("{} holds distances of vertices, and there are none; choose another format", format));
}

ShadingVertices split_shading_vertices(const LabelledMesh& labelled) {
  const Mesh& mesh = labelled.mesh;
  IdVector<FaceId, Vec3> normal;
  for (const FaceId f : mesh.faces()) normal.push_back(face_normal(mesh, f));
  const CreaseTest meet_at_crease(kShadingAngle);
  const auto is_crease = [&](HalfedgeId g, HalfedgeId h) {
    return meet_at_crease(normal[Mesh::face(g)], normal[Mesh::face(h)]);
  };
  const auto label_of = [&](HalfedgeId h) {
    return labelled.face_label == nullptr ? GeneratorId() : (*labelled.face_label)[Mesh::face(h)];
  };
  // Whether the corners of two faces can share a vertex, apart from their normals.
  const auto is_joined = [&](HalfedgeId g, HalfedgeId h) {
    return label_of(g) == label_of(h) && texture_of(labelled, g) == texture_of(labelled, h);
  };
  std::vector<ShadingVertex> split;  // by vertex
  IdVector<HalfedgeId, std::uint32_t> of_corner(mesh.halfedge_count());
  std::vector<HalfedgeId> ring;
  for (const VertexId v : mesh.vertices()) {
    ring.clear();
    for_each_outgoing(mesh, v, [&](HalfedgeId h) { ring.push_back(h); });
    // A closed ring begins after a crease or, without a crease, after a border or a seam. So faces that are adjacent in
    // the ring are also adjacent in the list.
    if (!mesh.is_boundary(v) && !begin_at_break(ring, is_crease)) {
      begin_at_break(ring, [&](HalfedgeId g, HalfedgeId h) { return !is_joined(g, h); });
    }
    for (std::size_t first = 0, last = 0; first < ring.size(); first = last) {
      for (last = first + 1; last < ring.size() && !is_crease(ring[last - 1], ring[last]);) ++last;
      const Eigen::Vector3f mean = mean_normal(mesh, normal, {ring.data() + first, last - first});
      for (std::size_t i = first; i < last; ++i) {
        if (i == first || !is_joined(ring[i - 1], ring[i])) {
          split.push_back({v, mean, label_of(ring[i]), texture_of(labelled, ring[i])});
        }
        of_corner[ring[i]] = std::uint32_t(split.size()) - 1;
      }
    }
  }
  return number_by_use(split, of_corner);
}

}  // namespace gvd::io
