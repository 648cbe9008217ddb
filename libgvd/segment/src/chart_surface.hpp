#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "base/parallel_chunks.hpp"
#include "gvd/charts.hpp"
#include "gvd/exact_field.hpp"
#include "gvd/face_regions.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// A connected part of a region.
struct Island {
  GeneratorId generator;
  std::int32_t euler_characteristic = 0;  ///< 1 for a disc
  std::vector<FaceId> faces;              ///< ascending
};

/// Finds the islands of separated regions, ascending by their first face. Faces without a label belong to none. Cost:
/// O(n).
std::vector<Island> find_islands(const Mesh& separated, const IdVector<FaceId, GeneratorId>& label);

/// The points of a face's corners in the plane; NaN if the face is not placed.
using PlaneCorners = std::array<Vec2, 3>;
inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
inline const Vec2 kNowhere(kNaN, kNaN);

/// A cut mesh with separated regions, and the shortest paths from their generators.
class ChartSurface {
 public:
  /// The arguments must outlive this object.
  ChartSurface(const Mesh& mesh, const Diagram& diagram, const CutMesh& cut, const ChartOptions& options);

  /// The faces of the cut mesh. Each island has vertices of its own.
  const Mesh& mesh() const { return separated_.mesh; }
  const std::vector<Island>& islands() const { return islands_; }
  const ParallelChunks& parallel() const { return parallel_; }

  FaceId parent(FaceId f) const { return cut_.parent[f]; }
  GeneratorId label(FaceId f) const { return cut_.label[f]; }
  /// The mesh of the diagram, on which paths run.
  const Mesh& surface() const { return surface_; }
  bool is_on_boundary(GeneratorId g) const { return gvd::is_on_boundary(surface_, diagram_.generators[g.index()]); }
  const ExactField& field() const { return field_; }

  /// A corner of face f, as a point of its parent.
  SurfacePoint point(FaceId f, int corner) const;
  /// The shortest path from a corner's vertex to the region's generator.
  GeodesicPath path(VertexId v) const {
    const HalfedgeId h = mesh().halfedge(v);
    return field_.path(point(Mesh::face(h), Mesh::corner(h)), label(Mesh::face(h)));
  }

 private:
  const Mesh& surface_;
  const Diagram& diagram_;
  const CutMesh& cut_;
  SeparatedMesh separated_;
  std::vector<Island> islands_;
  ParallelChunks parallel_;
  ExactField field_;
};

}  // namespace gvd
