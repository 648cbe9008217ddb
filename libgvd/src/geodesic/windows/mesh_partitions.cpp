#include "geodesic/windows/mesh_partitions.hpp"

#include <algorithm>
#include <tuple>

#include "geodesic/windows/kd_cut.hpp"

namespace gvd {
namespace {

std::vector<std::uint8_t> partition_vertices(const Mesh& mesh, std::int32_t parts) {
  const KdCut cut(mesh.positions(), parts);
  std::vector<std::uint8_t> partition_of_vertex;
  partition_of_vertex.reserve(mesh.positions().size());
  for (const Vec3& p : mesh.positions()) {
    partition_of_vertex.push_back(static_cast<std::uint8_t>(cut.box(p, partition_of_vertex.size())));
  }
  return partition_of_vertex;
}

}  // namespace

MeshPartitions::MeshPartitions(const Mesh& mesh, std::int32_t partition_faces, FaceFrames& frames)
    : count_(std::clamp(mesh.face_count() / partition_faces, 1, std::min(kMaxPartitions, mesh.vertex_count()))),
      place_count_(static_cast<std::size_t>(mesh.vertex_count())),
      partitions_(static_cast<std::size_t>(mesh.face_count()), 0),
      partition_(partitions_.data()) {
  if (count_ == 1) return;
  const std::vector<std::uint8_t> partition_of_vertex = partition_vertices(mesh, count_);
  const std::vector<ForeignCorner> corners = find_foreign_corners(mesh, partition_of_vertex);
  shared_.reserve(place_count_ + corners.size());
  shared_.assign(place_count_, -1);
  add_places(corners, partition_of_vertex);
  place_count_ = shared_.size();
  enter_places(corners, frames);
}

std::vector<MeshPartitions::ForeignCorner> MeshPartitions::find_foreign_corners(
    const Mesh& mesh, const std::vector<std::uint8_t>& partition_of_vertex) {
  std::vector<ForeignCorner> corners;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const auto& vertices = mesh.vertices(FaceId(f));
    const std::uint8_t part = partition_of_vertex[vertices[0].index()];
    partitions_[static_cast<std::size_t>(f)] = part;
    for (std::int32_t i = 1; i < 3; ++i) {
      const VertexId v = vertices[static_cast<std::size_t>(i)];
      if (partition_of_vertex[v.index()] != part) corners.push_back({v.value(), part, 3 * f + i});
    }
  }
  std::sort(corners.begin(), corners.end(), [](const ForeignCorner& a, const ForeignCorner& b) {
    return std::tie(a.vertex, a.part, a.halfedge) < std::tie(b.vertex, b.part, b.halfedge);
  });
  return corners;
}

void MeshPartitions::add_places(const std::vector<ForeignCorner>& corners,
                                const std::vector<std::uint8_t>& partition_of_vertex) {
  for (auto corner = corners.begin(); corner != corners.end();) {
    const std::int32_t vertex = corner->vertex;
    const auto begin = static_cast<std::int32_t>(places_.size());
    add_place(vertex, partition_of_vertex[static_cast<std::size_t>(vertex)]);
    for (; corner != corners.end() && corner->vertex == vertex; ++corner) {
      if (places_.back().part == corner->part) continue;
      shared_.push_back(-1);
      add_place(static_cast<std::int32_t>(shared_.size()) - 1, corner->part);
    }
    range_.resize(places_.size(), {begin, static_cast<std::int32_t>(places_.size())});
  }
}

void MeshPartitions::add_place(std::int32_t vertex, std::int32_t part) {
  shared_[static_cast<std::size_t>(vertex)] = static_cast<std::int32_t>(places_.size());
  places_.push_back({vertex, part});
}

void MeshPartitions::enter_places(const std::vector<ForeignCorner>& corners, FaceFrames& frames) const {
  const std::size_t vertices = frames.kind.size();
  frames.kind.reserve(shared_.size());  // `resize` alone would take twice as much
  frames.kind.resize(shared_.size());
  for (std::size_t place = vertices; place < shared_.size(); ++place) {
    const VertexId id(static_cast<std::int64_t>(place));
    frames.kind[id] = frames.kind[vertex(id.value())];
  }
  for (const ForeignCorner& c : corners) {
    std::int32_t& name = frames.frame[FaceId(c.halfedge / 3)].vertex[static_cast<std::size_t>(c.halfedge % 3)];
    for (const Place& place : places(shared(c.vertex))) {
      if (place.part == c.part) name = place.vertex;
    }
  }
}

}  // namespace gvd
