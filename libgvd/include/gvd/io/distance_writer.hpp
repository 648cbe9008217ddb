#pragma once

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gvd/exact_field.hpp"
#include "gvd/ids.hpp"
#include "gvd/io/labelled_mesh.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// Writes labels as an array of 32-bit integers, or as a table with two columns: `element`, which is "face" or
/// "vertex", and "label". An element without a label has -1.
void write_labels_npy(std::ostream& out, const std::vector<GeneratorId>& labels);
void write_labels_csv(std::ostream& out, const std::vector<GeneratorId>& labels, std::string_view element);

/// Writes the labels of nested levels, one column per level: as an array of the shape (faces, levels), or as a table
/// with the column "face" and a column with the name of each level.
void write_levels_npy(std::ostream& out, const std::vector<FaceNumbers>& levels);
void write_levels_csv(std::ostream& out, const std::vector<FaceNumbers>& levels);

/// A shortest path from one of the targets, the points whose distances were asked for.
struct TargetPath {
  std::int32_t target = 0;  ///< index of the target
  GeneratorId source;       ///< the source at which the path ends
  GeodesicPath path;        ///< its `generator` is not `source` if the sources were computed one after the other
  std::vector<Vec3> positions = {};  ///< positions of the path's points, mesh units
};

/// Rows of distances, all of the same length and contiguous in memory.
class DistanceRows {
 public:
  DistanceRows() = default;
  /// `values` has the distances of all rows, row by row.
  DistanceRows(std::vector<double> values, std::size_t rows = 1) : values_(std::move(values)), rows_(rows) {}

  std::size_t size() const { return rows_; }
  bool empty() const { return rows_ == 0; }
  /// The number of distances in a row.
  std::size_t points() const { return rows_ == 0 ? 0 : values_.size() / rows_; }
  const std::vector<double>& values() const { return values_; }
  std::span<double> operator[](std::size_t row) { return {values_.data() + row * points(), points()}; }
  std::span<const double> operator[](std::size_t row) const { return {values_.data() + row * points(), points()}; }
  /// All rows, for loops.
  std::vector<std::span<const double>> each() const {
    std::vector<std::span<const double>> all;
    for (std::size_t row = 0; row < rows_; ++row) all.push_back((*this)[row]);
    return all;
  }

 private:
  std::vector<double> values_;
  std::size_t rows_ = 0;
};

/// Distances of points from sources, with shortest paths and isolines, as files hold them.
struct DistanceTable {
  std::vector<SurfacePoint> sources = {};
  std::vector<SurfacePoint> targets = {};  ///< if empty, the distances are those of the vertices
  /// The vertices of the user's file that the sources and targets were given as; -1 for points that were given
  /// otherwise. Empty if unknown.
  std::vector<std::int64_t> source_vertices = {}, target_vertices = {};
  /// One row per source or, if `nearest` is not empty, a single row with the distances from the nearest source. A row
  /// has one distance per target or vertex. Mesh units, infinity if no source reaches the point.
  DistanceRows rows = {};
  std::vector<GeneratorId> nearest = {};  ///< the nearest source of each point; invalid if none reaches
  std::vector<TargetPath> paths = {};
  std::vector<Isoline> isolines = {};

  /// The source of a distance; invalid if the row has nearest sources and none reaches the point.
  GeneratorId source(std::size_t row, std::size_t point) const {
    return nearest.empty() ? GeneratorId(row) : nearest[point];
  }
  /// The vertex of the user's file that a source or target was given as; -1 if unknown or none.
  std::int64_t source_vertex(GeneratorId source) const {
    return source.valid() && !source_vertices.empty() ? source_vertices[source.index()] : -1;
  }
  std::int64_t target_vertex(std::size_t target) const {
    return target_vertices.empty() ? -1 : target_vertices[target];
  }
  /// "vertex 17" in the user's numbers, or "source 2" and "point 2" as their lists count them from 0.
  std::string source_name(GeneratorId source) const;
  std::string target_name(std::size_t target) const;
};

/// Writes the distances as an array of doubles of the shape (points) or, if there is a row for each source, (sources,
/// points).
void write_distances_npy(std::ostream& out, const DistanceTable& table);

/// Writes the distances as text. If there is a single distance to a target, it is alone on its line. Otherwise there is
/// one line per vertex or target, in their order: its vertex in the user's file, or -1 for a target that is no vertex,
/// and the distances of all rows, separated by blanks. Numbers have the fewest digits that read back to the same
/// double; a distance is inf if no source reaches the point.
void write_distances_text(std::ostream& out, const DistanceTable& table);

/// Writes one line per distance, with the columns source, vertex or target, and distance. If the table knows the user's
/// vertices, the columns source_vertex and, if there are targets, target_vertex follow. Sources and targets are counted
/// from 0 in their lists. A point that is no vertex has the vertex -1. If no source reaches a point, the source is -1
/// and the distance inf.
void write_distances_csv(std::ostream& out, const DistanceTable& table);

/// Writes the distances of the vertices as 32-bit floats: as GIFTI with one array per row, or as FreeSurfer's values of
/// the first row only. `faces` is the number of faces of the mesh.
void write_distances_gifti(std::ostream& out, const DistanceTable& table);
void write_distances_freesurfer(std::ostream& out, const DistanceTable& table, std::int32_t faces);

/// Writes one line per point of each path, with the columns path, source, target, length, face, b0, b1, b2, x, y, z,
/// source_vertex and target_vertex.
void write_paths_csv(std::ostream& out, const DistanceTable& table);

/// Writes the positions of one path: as an array of doubles of the shape (points, 3), or as OBJ with vertices and, if
/// there are several, a line through them.
void write_polyline_npy(std::ostream& out, const std::vector<Vec3>& positions);
void write_polyline_obj(std::ostream& out, const std::vector<Vec3>& positions);

/// Writes the whole table as `gvd-distance/1` (docs/schema). Infinity is written as null.
void write_distances_json(std::ostream& out, const Mesh& mesh, const DistanceTable& table);

/// Converts paths and isolines to polylines with the names path_0, path_1, ... and isoline_LEVEL. A path of a single
/// point is left out.
std::vector<MeshCurve> make_curves(const Mesh& mesh, const DistanceTable& table);

}  // namespace gvd
