#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geodesic/windows/face_frames.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// The mesh cut into compact parts of about equal size, through which windows are carried at the same time.
///
/// A part owns its faces and their halfedges. A vertex whose faces lie in several parts has a place of its own in each
/// of them, with a distance and a label, so that no part ever reads what another one writes: the vertex itself in the
/// first one, numbers beyond the last vertex in the others. The frames of the faces name places instead of vertices.
///
/// The cut depends on the mesh alone: vertices in boxes; a face goes with its first corner.
/// Memory: 1 byte a face; where there are several parts, 4 a vertex and 24 for each place of a shared one.
class MeshPartitions {
 public:
  struct Place {
    std::int32_t vertex;  ///< as the frames of that part name it
    std::int32_t part;
  };

  /// Lets the frames name places, and gives each place its vertex' kind. Cost: O(n).
  /// `partition_faces` >= 1: about so many faces make a part, of which there are kMaxPartitions at the most.
  MeshPartitions(const Mesh& mesh, std::int32_t partition_faces, FaceFrames& frames);
  MeshPartitions(const MeshPartitions&) = delete;
  MeshPartitions& operator=(const MeshPartitions&) = delete;

  /// From there on parts grow with the mesh: places of vertices, queues and mailboxes stay few.
  static constexpr std::int32_t kMaxPartitions = 64;

  std::int32_t count() const { return count_; }
  /// Number of places, of all vertices.
  std::size_t place_count() const { return place_count_; }
  std::int32_t of_face(std::int32_t f) const { return partition_[f]; }
  std::int32_t of_halfedge(std::int32_t h) const { return partition_[h / 3]; }

  /// Number of a place among those of shared vertices, or -1 where the vertex belongs to one part alone.
  std::int32_t shared(std::int32_t vertex) const {
    return count_ == 1 ? -1 : shared_[static_cast<std::size_t>(vertex)];
  }
  /// Number of places of shared vertices.
  std::size_t shared_count() const { return places_.size(); }
  /// All places of the vertex that a shared place belongs to; the vertex itself comes first.
  std::span<const Place> places(std::int32_t shared) const {
    const Range& range = range_[static_cast<std::size_t>(shared)];
    return {places_.data() + range.begin, places_.data() + range.end};
  }
  /// The vertex that a place belongs to.
  VertexId vertex(std::int32_t place) const {
    const std::int32_t number = shared(place);
    return VertexId(number < 0 ? place : places(number).front().vertex);
  }

 private:
  struct Range {
    std::int32_t begin, end;
  };
  /// A face's corner at a vertex that another part comes first at.
  struct ForeignCorner {
    std::int32_t vertex, part, halfedge;
  };

  std::vector<ForeignCorner> find_foreign_corners(const Mesh& mesh,
                                                  const std::vector<std::uint8_t>& partition_of_vertex);
  void add_places(const std::vector<ForeignCorner>& corners, const std::vector<std::uint8_t>& partition_of_vertex);
  void add_place(std::int32_t vertex, std::int32_t part);
  void enter_places(const std::vector<ForeignCorner>& corners, FaceFrames& frames) const;

  std::int32_t count_;
  std::size_t place_count_;
  std::vector<std::uint8_t> partitions_;  // [face]
  const std::uint8_t* partition_;         // the same, for the sake of the innermost loop
  std::vector<std::int32_t> shared_;      // [vertex or place] its number, or -1
  std::vector<Place> places_;             // those of one vertex one after the other
  std::vector<Range> range_;              // [place's number] of the places of its vertex
};

}  // namespace gvd
