// The elements of an output that several formats share: regions, bisectors as polylines, and vertices with normals.
//
// A renderer needs a vertex once for every normal. So the ring of faces around a vertex is split at creases, where the
// normal changes, and at borders between regions and seams of a texture, where it does not: shading runs on over these.
// Invariant: the order of regions, lines and vertices depends on the mesh alone, so that all formats agree and the same
// input gives the same bytes.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

#include "gvd/error.hpp"
#include "gvd/surface_point.hpp"
#include "io/writers/format_writers.hpp"
#include "mesh/creases.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd::io {
namespace {

/// As on the page of --view: curved surfaces look smooth, creases sharp. Degrees.
constexpr double kShadingAngle = 40;
constexpr std::uint32_t kUnseen = std::numeric_limits<std::uint32_t>::max();

class Splitter {
 public:
  explicit Splitter(const LabelledMesh& labelled) : labelled_(labelled), mesh_(labelled.mesh) {
    for (const FaceId f : mesh_.faces()) face_normal_.push_back(face_normal(mesh_, f));
    of_corner_.resize(mesh_.halfedge_count());
    for (const VertexId v : mesh_.vertices()) split(v);
  }

  /// Numbers the vertices in the order in which the faces use them.
  ShadingVertices run() {
    ShadingVertices result;
    std::vector<std::uint32_t> number(split_.size(), kUnseen);
    for (const HalfedgeId h : mesh_.halfedges()) {
      std::uint32_t& known = number[of_corner_[h]];
      if (known == kUnseen) {
        known = std::uint32_t(result.vertices.size());
        result.vertices.push_back(split_[of_corner_[h]]);
      }
      result.of_corner.push_back(known);
    }
    return result;
  }

 private:
  GeneratorId label_of(HalfedgeId h) const {
    return labelled_.face_label == nullptr ? GeneratorId() : (*labelled_.face_label)[Mesh::face(h)];
  }
  /// 0 for the corners of a face without texture coordinates: GLB has some for every vertex.
  Uv texture_of(HalfedgeId h) const {
    if (!labelled_.has_texture()) return {};
    const std::vector<Uv>& texture = labelled_.appearance->texture;
    for (const HalfedgeId corner : Mesh::halfedges(Mesh::face(h))) {
      if (!fits_floats(texture[corner.index()])) return {};
    }
    return texture[h.index()];
  }
  /// Whether the corners of two faces can be one vertex, but for their normals.
  bool is_joined(HalfedgeId g, HalfedgeId h) const {
    return label_of(g) == label_of(h) && texture_of(g) == texture_of(h);
  }

  bool is_crease(HalfedgeId g, HalfedgeId h) const {
    return meet_at_crease_(face_normal_[Mesh::face(g)], face_normal_[Mesh::face(h)]);
  }

  /// Turns a closed ring so that it begins behind a crease or, where there is none, behind a border or a seam.
  /// So faces that lie together in the ring lie together in the list.
  void begin_at_break() {
    const auto turn_to = [this](auto is_break) {
      for (std::size_t i = 0; i < ring_.size(); ++i) {
        if (!is_break(ring_[(i + ring_.size() - 1) % ring_.size()], ring_[i])) continue;
        std::rotate(ring_.begin(), ring_.begin() + i, ring_.end());
        return true;
      }
      return false;
    };
    if (turn_to([this](HalfedgeId g, HalfedgeId h) { return is_crease(g, h); })) return;
    turn_to([this](HalfedgeId g, HalfedgeId h) { return !is_joined(g, h); });
  }

  Eigen::Vector3f mean_normal(std::size_t first, std::size_t last) const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = first; i < last; ++i)
      sum += corner_angle(mesh_, ring_[i]) * face_normal_[Mesh::face(ring_[i])];
    const Vec3 unit = sum.stableNormalized();
    return unit.isZero(0) ? Eigen::Vector3f(0, 0, 1) : Eigen::Vector3f(unit.cast<float>());
  }

  void split(VertexId v) {
    ring_.clear();
    for_each_outgoing(mesh_, v, [this](HalfedgeId h) { ring_.push_back(h); });
    if (!mesh_.is_boundary(v)) begin_at_break();
    for (std::size_t first = 0, last = 0; first < ring_.size(); first = last) {
      for (last = first + 1; last < ring_.size() && !is_crease(ring_[last - 1], ring_[last]);) ++last;
      const Eigen::Vector3f normal = mean_normal(first, last);
      for (std::size_t i = first; i < last; ++i) {
        if (i == first || !is_joined(ring_[i - 1], ring_[i])) {
          split_.push_back({v, normal, label_of(ring_[i]), texture_of(ring_[i])});
        }
        of_corner_[ring_[i]] = std::uint32_t(split_.size()) - 1;
      }
    }
  }

  const LabelledMesh& labelled_;
  const Mesh& mesh_;
  IdVector<FaceId, Vec3> face_normal_;
  CreaseTest meet_at_crease_{kShadingAngle, CreaseRule::cosine};
  std::vector<ShadingVertex> split_;  ///< by vertex
  IdVector<HalfedgeId, std::uint32_t> of_corner_;
  std::vector<HalfedgeId> ring_;  ///< of one vertex, counter-clockwise
};

}  // namespace

std::vector<Region> collect_regions(const LabelledMesh& mesh) {
  // As an unsigned number the invalid label -1 is the largest: it comes last.
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

ShadingVertices split_shading_vertices(const LabelledMesh& mesh) { return Splitter(mesh).run(); }

}  // namespace gvd::io
