#pragma once

#include <cstdint>
#include <vector>

#include "gvd/face_regions.hpp"
#include "gvd/given_regions.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/observer.hpp"
#include "gvd/soup.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// Where the points of a list are on a surface that is parted into regions.
struct PlacedPoints {
  std::vector<SurfacePoint> places;  ///< of the points, one point after the other
  std::vector<std::int32_t> point;   ///< whose place each one is
};

/// The surface that distances are measured on: the input, or its regions, which paths don't leave.
class MeasuredSurface {
 public:
  /// Keeps a reference to the input. Notes how many regions there are. Throws what `find_regions` throws.
  MeasuredSurface(const CheckedMesh& input, const GivenRegions& given, Observer& observer);

  /// The input, or its faces with the vertices on the borders of regions doubled: surface points are those of both.
  const Mesh& mesh() const { return is_parted() ? separated_.mesh : input_.mesh; }

  /// The vertex of the input that each vertex of `mesh()` is, or is a copy of.
  VertexId input_vertex(VertexId v) const { return is_parted() ? separated_.input_vertex[v] : v; }

  /// The places of points of the input. A point on the border of regions has one in each of those, since it belongs to
  /// all of them; a point in faces that are left out has none.
  PlacedPoints place(const std::vector<SurfacePoint>& points) const;

  /// Whether a face of the input is in no region.
  bool is_left_out(FaceId f) const { return is_parted() && regions_[f] < 0; }

  std::int64_t regions() const;         ///< number of regions
  std::int64_t left_out_faces() const;  ///< faces in no region

  /// Whether regions part it.
  bool is_parted() const { return !regions_.empty(); }

 private:
  const CheckedMesh& input_;
  FaceRegions regions_;  // empty: all faces are one
  SeparatedMesh separated_;
};

}  // namespace gvd
