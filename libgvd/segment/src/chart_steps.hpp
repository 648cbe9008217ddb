#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "base/parallel_chunks.hpp"
#include "gvd/charts.hpp"
#include "gvd/exact_field.hpp"
#include "gvd/face_regions.hpp"
#include "gvd/surface_point.hpp"

// The steps of `make_charts`: the islands, their maps to the plane, and their places in the square.

namespace gvd {

/// A connected part of a region.
struct Island {
  GeneratorId generator;
  std::vector<FaceId> faces;  ///< ascending
};

/// The islands of regions that were separated, ascending by their first face; none for faces without a label. Cost:
/// O(n).
std::vector<Island> find_islands(const Mesh& separated, const IdVector<FaceId, GeneratorId>& label);

/// Vertices - edges + faces of an island with vertices of its own: 1 for a disc. Cost: O(n log n).
std::int64_t euler_characteristic(const Mesh& mesh, const Island& island);

/// The points of a face's corners in the plane; not numbers for one that is not placed.
using PlaneCorners = std::array<Vec2, 3>;
inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
inline const Vec2 kNowhere(kNaN, kNaN);

/// A cut mesh whose regions are taken apart, with the paths from their generators.
class ChartSurface {
 public:
  /// The arguments must outlive this.
  ChartSurface(const Mesh& mesh, const Diagram& diagram, const CutMesh& cut, const ChartOptions& options);

  /// The faces of the cut mesh, with vertices of their own in each island.
  const Mesh& mesh() const { return separated_.mesh; }
  const std::vector<Island>& islands() const { return islands_; }
  const ParallelChunks& parallel() const { return parallel_; }

  FaceId parent(FaceId f) const { return cut_.parent[f]; }
  GeneratorId label(FaceId f) const { return cut_.label[f]; }
  /// The mesh of the diagram, whose points the paths connect.
  const Mesh& surface() const { return surface_; }
  bool is_on_boundary(GeneratorId g) const { return gvd::is_on_boundary(surface_, diagram_.generators[g.index()]); }
  const ExactField& field() const { return field_; }

  /// A corner of a face, on its parent.
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

// chart_maps.cpp

/// Lays all faces by logarithms, mesh units round their generators. Sets `torn` for those laid by their centre's path.
/// Cost: O(faces crossed) for each vertex and torn face.
std::vector<PlaneCorners> map_by_logarithms(const ChartSurface& surface, IdVector<FaceId, char>& torn);

/// Maps of a disc to the plane, from the best looking to the safest.
inline constexpr int kFlatMaps = 4;

/// The border of an island that is a disc, counter-clockwise.
struct IslandBorder {
  std::vector<VertexId> vertices;
  std::vector<double> side;      ///< length from each vertex to the next one, mesh units
  std::vector<double> distance;  ///< from the generator, mesh units; empty where that is on the boundary
};

/// Cost: O(n), and that of a path for each vertex of the border.
IslandBorder measure_border(const ChartSurface& surface, const Island& island);

/// Lays the faces of an island, a disc, by the `attempt`-th map; false where its border has no such shape. The area is
/// that of the faces, mesh units. Writes to these faces only.
bool map_flat(const Mesh& mesh, const Island& island, const IslandBorder& border, int attempt,
              std::vector<PlaneCorners>& corners);

// make_charts.cpp

/// Boxes in a square.
struct Packing {
  std::vector<Vec2> at;  ///< their lower left corners
  double side = 0;       ///< of the square
};

/// Puts boxes of these sizes on shelves, the highest first, with free space round each (kChartMargin). Sides of the
/// square are tried in steps of 1 %, and the first that holds all is taken. Ties keep the order. Cost: O(n log n) for
/// each side.
Packing pack_boxes(const std::vector<Vec2>& sizes);

}  // namespace gvd
