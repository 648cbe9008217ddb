#include "geodesic/windows/propagation/mesh_partitions.hpp"

#include <algorithm>
#include <tuple>

#include "geodesic/windows/propagation/kd_cut.hpp"

namespace gvd {
namespace {

IdVector<VertexId, std::uint8_t> partition_vertices(const Mesh& mesh, std::int32_t partitions) {
  const KdCut cut(mesh.positions(), partitions);
  IdVector<VertexId, std::uint8_t> partition_of_vertex;
  partition_of_vertex.reserve(mesh.positions().size());
  for (const Vec3& p : mesh.positions()) {
    partition_of_vertex.push_back(static_cast<std::uint8_t>(cut.box(p, partition_of_vertex.size())));
  }
  return partition_of_vertex;
}

}  // namespace

MeshPartitions::MeshPartitions(const Mesh& mesh, std::int32_t partition_faces, FaceFrames& frames)
    : count_(std::clamp(mesh.face_count() / partition_faces, 1, std::min(kMaxPartitions, mesh.vertex_count()))),
      copy_count_(static_cast<std::size_t>(mesh.vertex_count())),
      partitions_(static_cast<std::size_t>(mesh.face_count()), 0),
      of_face_(partitions_.data()) {
  if (count_ == 1) return;
  const PartitionOfVertex partition_of_vertex = partition_vertices(mesh, count_);
  const std::vector<ForeignCorner> corners = find_foreign_corners(mesh, partition_of_vertex);
  shared_.reserve(copy_count_ + corners.size());
  shared_.assign(copy_count_, SharedCopyId());
  add_copies(corners, partition_of_vertex);
  copy_count_ = shared_.size();
  enter_copies(corners, frames);
}

std::vector<MeshPartitions::ForeignCorner> MeshPartitions::find_foreign_corners(
    const Mesh& mesh, const PartitionOfVertex& partition_of_vertex) {
  std::vector<ForeignCorner> corners;
  for (std::int32_t i = 0; i < mesh.face_count(); ++i) {
    const FaceId f(i);
    const auto& vertices = mesh.vertices(f);
    const std::uint8_t partition = partition_of_vertex[vertices[0]];
    partitions_[f.index()] = partition;
    for (int corner = 1; corner < 3; ++corner) {
      const VertexId v = vertices[corner];
      if (partition_of_vertex[v] == partition) continue;
      corners.push_back({v, PartitionId(partition), Mesh::halfedge(f, corner)});
    }
  }
  std::sort(corners.begin(), corners.end(), [](const ForeignCorner& a, const ForeignCorner& b) {
    return std::tie(a.vertex, a.partition, a.halfedge) < std::tie(b.vertex, b.partition, b.halfedge);
  });
  return corners;
}

void MeshPartitions::add_copies(const std::vector<ForeignCorner>& corners,
                                const PartitionOfVertex& partition_of_vertex) {
  for (auto corner = corners.begin(); corner != corners.end();) {
    const VertexId vertex = corner->vertex;
    const auto begin = static_cast<std::int32_t>(copies_.size());
    add_copy(first_copy(vertex), PartitionId(partition_of_vertex[vertex]));
    for (; corner != corners.end() && corner->vertex == vertex; ++corner) {
      if (copies_.raw().back().partition == corner->partition) continue;
      add_copy(shared_.push_back(SharedCopyId()), corner->partition);
    }
    range_.resize(copies_.size(), {begin, static_cast<std::int32_t>(copies_.size())});
  }
}

void MeshPartitions::add_copy(VertexCopyId vertex, PartitionId partition) {
  shared_[vertex] = copies_.push_back({vertex, partition});
}

void MeshPartitions::enter_copies(const std::vector<ForeignCorner>& corners, FaceFrames& frames) const {
  const std::size_t vertices = frames.kind.size();
  frames.kind.reserve(shared_.size());  // `resize` alone would take twice as much
  frames.kind.resize(shared_.size());
  for (std::size_t i = vertices; i < shared_.size(); ++i) {
    const VertexCopyId copy(static_cast<std::int64_t>(i));
    frames.kind[copy] = frames.kind[first_copy(vertex(copy))];
  }
  for (const ForeignCorner& c : corners) {
    const auto corner = static_cast<std::size_t>(Mesh::corner(c.halfedge));
    VertexCopyId& entered = frames.frame[Mesh::face(c.halfedge)].vertex[corner];
    for (const VertexCopy& copy : copies(shared(first_copy(c.vertex)))) {
      if (copy.partition == c.partition) entered = copy.vertex;
    }
  }
}

}  // namespace gvd
