// The mesh cut into partitions, in which windows are propagated at the same time.
//
// Idea: a k-d tree over a sample of the vertices cuts space into boxes of about as many vertices each. A vertex that
// several partitions touch gets a copy in each of them, and the frames of the faces refer to the copies.
// Source: k-d trees of Bentley (1975).
// Invariant: the cut depends on the mesh alone, never on the number of threads. The copies of one vertex follow each
// other, the first one in the partition of the vertex's own box.
#include "geodesic/windows/propagation/mesh_partitions.hpp"

#include <algorithm>
#include <tuple>

namespace gvd {
namespace {

/// Number of points that are sampled. With it, the contents of 64 boxes differ by a few tenths.
constexpr std::size_t kSample = 4096;

/// A pseudo-random number in [0, count) that depends on i and count alone. A constant stride would sample every row of
/// a grid in the same column. Source: splitmix64's output function (Steele, Lea and Flood, 2014).
std::size_t scatter(std::uint64_t i, std::size_t count) {
  i = (i ^ (i >> 30)) * 0xbf58476d1ce4e5b9u;
  i = (i ^ (i >> 27)) * 0x94d049bb133111ebu;
  return (i ^ (i >> 31)) % count;
}

template <class Samples>
int longest_axis(const Samples& samples) {
  Eigen::AlignedBox3d box;
  for (const auto& s : samples) box.extend(s.point);
  Eigen::Index axis = 0;
  box.sizes().maxCoeff(&axis);
  return static_cast<int>(axis);
}

}  // namespace

KdCut::KdCut(std::span<const Vec3> points, std::int32_t boxes) {
  std::vector<Sample> samples;
  const std::size_t step = std::max(points.size() / kSample, std::size_t{1});
  for (std::size_t begin = 0; begin < points.size(); begin += step) {
    const std::size_t i = begin + scatter(begin, std::min(step, points.size() - begin));
    samples.push_back({points[i], i});
  }
  root_ = cut(samples, 0, boxes);
}

std::int32_t KdCut::cut(std::span<Sample> samples, std::int32_t first_box, std::int32_t boxes) {
  if (boxes == 1) return ~first_box;
  const int axis = longest_axis(samples);
  const std::int32_t boxes_below = boxes / 2;
  const std::size_t below = samples.size() * boxes_below / boxes;
  std::nth_element(samples.begin(), samples.begin() + below, samples.end(), [axis](const Sample& a, const Sample& b) {
    return std::tuple(a.point[axis], a.index) < std::tuple(b.point[axis], b.index);
  });
  const Sample& split = samples[below];
  const auto node = static_cast<std::int32_t>(nodes_.size());
  nodes_.push_back({axis, split.point[axis], split.index, 0, 0});
  const std::int32_t lower = cut(samples.first(below), first_box, boxes_below);
  const std::int32_t upper = cut(samples.subspan(below), first_box + boxes_below, boxes - boxes_below);
  nodes_[node].below = lower;
  nodes_[node].above = upper;
  return node;
}

MeshPartitions::MeshPartitions(const Mesh& mesh, const ElementCounts& before, std::int32_t partition_faces,
                               FaceFrames& frames)
    : count_(std::clamp(before.faces / partition_faces, 1, std::min(kMaxPartitions, before.vertices))),
      copy_count_(mesh.vertex_count()),
      partitions_(mesh.face_count(), 0),
      of_face_(partitions_.data()) {
  if (count_ == 1) return;
  const auto positions = std::span(mesh.positions()).first(before.vertices);
  cut_.emplace(positions, count_);
  of_input_.reserve(positions.size());
  for (const Vec3& p : positions) of_input_.push_back(static_cast<std::uint8_t>(cut_->box(p, of_input_.size())));
  assign(mesh, frames);
}

void MeshPartitions::update(const Mesh& mesh, FaceFrames& frames) {
  copy_count_ = mesh.vertex_count();
  partitions_.assign(mesh.face_count(), 0);
  of_face_ = partitions_.data();
  if (count_ == 1) return;
  for (const ForeignCorner& c : foreign_) {
    const FaceId f = Mesh::face(c.halfedge);
    if (f.value() >= mesh.face_count()) continue;
    frames.frame[f].vertex[Mesh::corner(c.halfedge)] = first_copy(mesh.from(c.halfedge));
  }
  shared_ = {};
  copies_ = {};
  range_ = {};
  assign(mesh, frames);
}

/// Gives each face the partition of its first corner, and each shared vertex its copies.
void MeshPartitions::assign(const Mesh& mesh, FaceFrames& frames) {
  PartitionOfVertex partition_of_vertex = of_input_;
  for (std::size_t i = of_input_.size(); i < mesh.positions().size(); ++i) {
    partition_of_vertex.push_back(static_cast<std::uint8_t>(cut_->box(mesh.positions()[i], i)));
  }
  foreign_ = find_foreign_corners(mesh, partition_of_vertex);
  shared_.reserve(copy_count_ + foreign_.size());
  shared_.assign(copy_count_, SharedCopyId());
  add_copies(foreign_, partition_of_vertex);
  copy_count_ = shared_.size();
  enter_copies(foreign_, frames);
}

std::vector<MeshPartitions::ForeignCorner> MeshPartitions::find_foreign_corners(
    const Mesh& mesh, const PartitionOfVertex& partition_of_vertex) {
  std::vector<ForeignCorner> corners;
  for (const FaceId f : mesh.faces()) {
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
    const std::int32_t begin = copies_.count();
    add_copy(first_copy(vertex), PartitionId(partition_of_vertex[vertex]));
    for (; corner != corners.end() && corner->vertex == vertex; ++corner) {
      if (copies_.raw().back().partition == corner->partition) continue;
      add_copy(shared_.push_back(SharedCopyId()), corner->partition);
    }
    range_.resize(copies_.size(), {begin, copies_.count()});
  }
}

void MeshPartitions::enter_copies(const std::vector<ForeignCorner>& corners, FaceFrames& frames) const {
  const std::size_t vertices = frames.kind.size();
  frames.kind.reserve(shared_.size());  // `resize` alone could take twice as much memory
  frames.kind.resize(shared_.size());
  for (std::size_t i = vertices; i < shared_.size(); ++i) {
    const VertexCopyId copy(i);
    frames.kind[copy] = frames.kind[first_copy(vertex(copy))];
  }
  for (const ForeignCorner& c : corners) {
    VertexCopyId& entered = frames.frame[Mesh::face(c.halfedge)].vertex[Mesh::corner(c.halfedge)];
    for (const VertexCopy& copy : copies(shared(first_copy(c.vertex)))) {
      if (copy.partition == c.partition) entered = copy.vertex;
    }
  }
}

}  // namespace gvd
