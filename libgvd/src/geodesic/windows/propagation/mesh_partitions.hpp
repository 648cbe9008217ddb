#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geodesic/windows/face_frames.hpp"
#include "gvd/mesh.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// A list of points cut into boxes of about as many points each, by cutting the longest side of a box repeatedly.
/// Points with the same coordinate are ordered by their index in the list.
class KdCut {
 public:
  /// There must be at least one point; some thousands of points are sampled. `boxes` is in [1, number of points].
  KdCut(std::span<const Vec3> points, std::int32_t boxes);

  /// The box, in [0, boxes), of point p, which has the index i in the list.
  std::int32_t box(const Vec3& p, std::size_t i) const {
    std::int32_t node = root_;
    while (node >= 0) {
      const Node& n = nodes_[node];
      const double x = p[n.axis];
      node = x < n.split || (x == n.split && i < n.split_index) ? n.below : n.above;
    }
    return ~node;
  }

 private:
  struct Node {
    int axis;
    double split;
    std::size_t split_index;    // index of the point at the split
    std::int32_t below, above;  // nodes, or ~boxes
  };

  struct Sample {
    Vec3 point;
    std::size_t index;
  };

  std::int32_t cut(std::span<Sample> samples, std::int32_t first_box, std::int32_t boxes);

  std::vector<Node> nodes_;
  std::int32_t root_;
};

/// Numbers of a mesh's vertices and faces.
struct ElementCounts {
  std::int32_t vertices = 0, faces = 0;
};

/// The mesh cut into compact partitions of about equal size, in which windows are propagated at the same time.
///
/// A partition owns its faces and their halfedges. A vertex whose faces lie in several partitions has a copy in each of
/// them, with a distance and a label. No partition therefore ever reads what another one writes. The frames of the
/// faces refer to these copies.
///
/// The cut depends on the mesh alone: vertices are sorted into boxes, and a face belongs to the box of its first
/// corner. Vertices that generators have added do not move the boxes, so that the cut is the same for other generators.
/// Memory: 1 byte a face; with several partitions, also 4 bytes a vertex and 24 bytes for each copy of a shared vertex.
class MeshPartitions {
 public:
  struct VertexCopy {
    VertexCopyId vertex;
    PartitionId partition;
  };

  /// Lets the frames refer to vertex copies, and gives each copy its vertex's kind. Cost: O(n).
  /// `partition_faces` is the approximate number of faces of a partition, >= 1; there are at most kMaxPartitions
  /// partitions. `before` are the numbers of elements before generators were inserted; these elements come first.
  MeshPartitions(const Mesh& mesh, const ElementCounts& before, std::int32_t partition_faces, FaceFrames& frames);
  MeshPartitions(const Mesh& mesh, std::int32_t partition_faces, FaceFrames& frames)
      : MeshPartitions(mesh, {mesh.vertex_count(), mesh.face_count()}, partition_faces, frames) {}
  /// Follows a change of the mesh in faces that generators split, and of their frames, which refer to first copies.
  /// Cost: O(n) with small constants.
  void update(const Mesh& mesh, FaceFrames& frames);
  MeshPartitions(const MeshPartitions&) = delete;
  MeshPartitions& operator=(const MeshPartitions&) = delete;

  /// The largest number of partitions. Larger meshes get larger partitions, so that there are few vertex copies, queues
  /// and mailboxes.
  static constexpr std::int32_t kMaxPartitions = 64;

  std::int32_t count() const { return count_; }
  /// Number of vertex copies, those of unshared vertices included.
  std::size_t copy_count() const { return copy_count_; }
  PartitionId of_face(FaceId f) const { return PartitionId(of_face_[f.value()]); }
  PartitionId of_halfedge(HalfedgeId h) const { return PartitionId(of_face_[h.value() / 3]); }

  /// Number of a copy among the copies of shared vertices; invalid if the vertex belongs to a single partition.
  SharedCopyId shared(VertexCopyId v) const { return count_ == 1 ? SharedCopyId() : shared_[v]; }
  /// Number of copies of shared vertices.
  std::size_t shared_count() const { return copies_.size(); }
  /// All copies of the vertex to which a shared copy belongs; the first copy comes first.
  std::span<const VertexCopy> copies(SharedCopyId shared) const {
    const Range& range = range_[shared];
    return {copies_.raw().data() + range.begin, copies_.raw().data() + range.end};
  }
  /// The vertex to which a copy belongs.
  VertexId vertex(VertexCopyId v) const {
    const SharedCopyId number = shared(v);
    return VertexId((number.valid() ? copies(number).front().vertex : v).value());
  }

 private:
  struct Range {
    std::int32_t begin, end;
  };
  /// A face's corner at a vertex whose first copy belongs to another partition.
  struct ForeignCorner {
    VertexId vertex;
    PartitionId partition;
    HalfedgeId halfedge;
  };
  using PartitionOfVertex = IdVector<VertexId, std::uint8_t>;

  void assign(const Mesh& mesh, FaceFrames& frames);
  std::vector<ForeignCorner> find_foreign_corners(const Mesh& mesh, const PartitionOfVertex& partition_of_vertex);
  void add_copies(const std::vector<ForeignCorner>& corners, const PartitionOfVertex& partition_of_vertex);
  void add_copy(VertexCopyId vertex, PartitionId partition) {
    shared_[vertex] = copies_.push_back({vertex, partition});
  }
  void enter_copies(const std::vector<ForeignCorner>& corners, FaceFrames& frames) const;

  std::int32_t count_;
  std::size_t copy_count_;
  std::optional<KdCut> cut_;                     // none if there is a single partition
  PartitionOfVertex of_input_;                   // partitions of the vertices before generators were inserted
  std::vector<ForeignCorner> foreign_;           // corners whose frames don't refer to first copies
  std::vector<std::uint8_t> partitions_;         // [face]
  const std::uint8_t* of_face_;                  // the same array, with one indirection less in the innermost loop
  IdVector<VertexCopyId, SharedCopyId> shared_;  // invalid if the vertex is not shared
  IdVector<SharedCopyId, VertexCopy> copies_;    // copies of the same vertex follow each other
  IdVector<SharedCopyId, Range> range_;          // for each copy, the range of all copies of its vertex
};

}  // namespace gvd
