#include "io/writers/mesh_formats.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "gvd/error.hpp"

namespace gvd::io {
namespace {

/// Linear in the face; a vertex with weight 0 has no say, even where its distance is infinite.
double interpolate(const Mesh& mesh, const IdVector<VertexId, double>& values, const SurfacePoint& point) {
  if (values.empty()) return std::numeric_limits<double>::infinity();
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (point.bary[i] > 0) sum += point.bary[i] * values[mesh.vertices(point.face)[i]];
  }
  return sum;
}

}  // namespace

std::vector<Region> collect_regions(const LabelledMesh& mesh) {
  // As an unsigned number the invalid -1 is the largest: it comes last.
  std::map<std::uint32_t, Region> regions;
  for (int f = 0; f < mesh.mesh.face_count(); ++f) {
    const GeneratorId label = mesh.face_label != nullptr ? (*mesh.face_label)[FaceId(f)] : GeneratorId();
    Region& region = regions[static_cast<std::uint32_t>(label.value())];
    region.label = label;
    region.faces.push_back(FaceId(f));
  }
  std::vector<Region> result;
  for (auto& [label, region] : regions) result.push_back(std::move(region));
  return result;
}

std::string region_name(GeneratorId label) {
  return label.valid() ? fmt::format("region_{}", label.value()) : "unlabelled";
}

std::vector<BisectorLine> collect_bisector_lines(const LabelledMesh& mesh) {
  std::vector<BisectorLine> lines;
  if (mesh.diagram == nullptr) return lines;
  const Mesh& surface = mesh.diagram_mesh != nullptr ? *mesh.diagram_mesh : mesh.mesh;
  for (const Bisector& bisector : mesh.diagram->bisectors) {
    if (bisector.points.size() < 2) continue;
    BisectorLine& line = lines.emplace_back();
    line.left = bisector.left;
    line.right = bisector.right;
    const auto add = [&](const SurfacePoint& point) {
      line.points.push_back(position(surface, point));
      line.distance.push_back(interpolate(surface, mesh.diagram->vertex_distance, point));
    };
    for (const SurfacePoint& point : bisector.points) add(point);
    if (bisector.closed) add(bisector.points.front());
  }
  return lines;
}

void check_single_precision(const Mesh& mesh, const char* format) {
  const double largest = mesh.largest_coordinate();
  using Float = std::numeric_limits<float>;
  const auto refuse = [&](const std::string& why) {
    throw Error(ErrorCode::unwritable_output,
                fmt::format("{} holds 32-bit floats, and {}; choose PLY, OBJ, OFF or VTP", format, why));
  };
  if (largest > Float::max()) refuse(fmt::format("the coordinate {} is too large for one", largest));
  // Two neighbouring floats lie up to this far apart there: every vertex would end on one of a few places.
  const double step = std::max<double>(largest * Float::epsilon(), Float::min());
  if (mesh.bbox_diagonal() <= step) {
    refuse(fmt::format("a mesh of size {} at the coordinate {} is lost between two of them", mesh.bbox_diagonal(),
                       largest));
  }
}

}  // namespace gvd::io
