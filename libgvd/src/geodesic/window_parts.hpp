#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geodesic/window_field.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// The mesh cut into compact parts of about equal size, through which windows are carried at the same time.
///
/// A part owns its faces and their halfedges. A vertex whose faces lie in several parts has a place of its own in each
/// of them, with a distance and a label, so that no part ever reads what another one writes: the vertex itself in the
/// first one, numbers beyond the last vertex in the others. While this object lives between construction and
/// `restore`, the frames of the faces name places instead of vertices.
///
/// The cut depends on the mesh alone: vertices in boxes; a face goes with its first corner.
/// Memory: 1 byte a face; where there are several parts, 4 a vertex and 40 for each place.
class WindowParts {
 public:
  struct Place {
    std::int32_t vertex;  ///< as the frames of that part name it, and the field's arrays
    std::int32_t part;
  };

  /// Changes the field's frames, and makes room for the places in its arrays. Cost: O(n).
  /// `part_faces` >= 1: about so many faces make a part.
  WindowParts(const Mesh& mesh, std::int32_t part_faces, WindowField& field);
  /// Gives the frames their vertices back, and the field's arrays their sizes.
  void restore(const Mesh& mesh, WindowField& field) const;

  std::int32_t count() const { return count_; }
  std::int32_t of_face(std::int32_t f) const { return part_[f]; }
  std::int32_t of_halfedge(std::int32_t h) const { return part_[h / 3]; }

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

  std::vector<ForeignCorner> find_foreign_corners(const Mesh& mesh, const std::vector<std::uint8_t>& part_of_vertex);
  void add_places(const std::vector<ForeignCorner>& corners, const std::vector<std::uint8_t>& part_of_vertex);
  void add_place(std::int32_t vertex, std::int32_t part);
  void enter_places(const std::vector<ForeignCorner>& corners, WindowField& field) const;

  std::int32_t count_;
  std::vector<std::uint8_t> parts_;      // [face]
  const std::uint8_t* part_;             // the same, for the sake of the innermost loop
  std::vector<std::int32_t> shared_;     // [vertex or place] its number, or -1
  std::vector<Place> places_;            // those of one vertex one after the other
  std::vector<Range> range_;             // [place's number] of the places of its vertex
  std::vector<std::int32_t> halfedges_;  // whose start is not named by its vertex
};

}  // namespace gvd
