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

/// Writes labels: as an array of 32-bit integers, or as a table with the columns `element`, which is face or vertex,
/// and label. -1 where there is none.
void write_labels_npy(std::ostream& out, const std::vector<GeneratorId>& labels);
void write_labels_csv(std::ostream& out, const std::vector<GeneratorId>& labels, std::string_view element);

/// Writes the labels of nested levels, a column for each: an array of the shape (faces, levels), or a table with the
/// columns face and the names of the levels.
void write_levels_npy(std::ostream& out, const std::vector<FaceNumbers>& levels);
void write_levels_csv(std::ostream& out, const std::vector<FaceNumbers>& levels);

/// A shortest path from a point that distances were asked for.
struct TargetPath {
  std::int32_t target = 0;           ///< index of that point
  GeneratorId source;                ///< where the path ends
  GeodesicPath path;                 ///< its generator is another number where one source after the other was computed
  std::vector<Vec3> positions = {};  ///< of its points, mesh units
};

/// Rows of distances, all of one length and one behind the other in memory.
class DistanceRows {
 public:
  DistanceRows() = default;
  /// `values`: those of all rows.
  DistanceRows(std::vector<double> values, std::size_t rows = 1) : values_(std::move(values)), rows_(rows) {}

  std::size_t size() const { return rows_; }
  bool empty() const { return rows_ == 0; }
  /// The length of each.
  std::size_t points() const { return rows_ == 0 ? 0 : values_.size() / rows_; }
  const std::vector<double>& values() const { return values_; }
  std::span<double> operator[](std::size_t row) { return {values_.data() + row * points(), points()}; }
  std::span<const double> operator[](std::size_t row) const { return {values_.data() + row * points(), points()}; }
  /// All of them, to walk through.
  std::vector<std::span<const double>> each() const {
    std::vector<std::span<const double>> all;
    for (std::size_t row = 0; row < rows_; ++row) all.push_back((*this)[row]);
    return all;
  }

 private:
  std::vector<double> values_;
  std::size_t rows_ = 0;
};

/// Distances of points from sources, and curves of them, for files.
struct DistanceTable {
  std::vector<SurfacePoint> sources = {};
  std::vector<SurfacePoint> targets = {};  ///< empty: the distances are those of the vertices
  /// The vertices of the user's file that the sources and targets were given as, -1 for points that were given by other
  /// coordinates. Empty: not known.
  std::vector<std::int64_t> source_vertices = {}, target_vertices = {};
  /// A row of all points for each source or, where `nearest` is not empty, one row of the nearest source. Mesh units,
  /// infinity where no source reaches.
  DistanceRows rows = {};
  std::vector<GeneratorId> nearest = {};  ///< of each point; invalid where no source reaches
  std::vector<TargetPath> paths = {};
  std::vector<Isoline> isolines = {};

  /// The source of a distance; invalid where none reaches.
  GeneratorId source(std::size_t row, std::size_t point) const {
    return nearest.empty() ? GeneratorId(row) : nearest[point];
  }
  /// The user's vertex; -1 where a source or target is none.
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

/// Writes the distances as an array of doubles of the shape (points), or (sources, points) of all sources.
void write_distances_npy(std::ostream& out, const DistanceTable& table);

/// Writes the distances as text. A single distance to a target is alone on its line. Otherwise there is a line for each
/// vertex or target, in their order: its vertex in the user's file, or -1 for a target that is none, and its distances,
/// one for each row, behind blanks. Numbers have the fewest digits that read back to the same double; inf where no
/// source reaches.
void write_distances_text(std::ostream& out, const DistanceTable& table);

/// Writes a line for each distance, with the columns source, vertex or target, and distance. Where the table knows the
/// user's vertices, source_vertex follows and, where there are targets, target_vertex. Sources and targets are counted
/// from 0 in their lists; -1 for none, and inf where no source reaches.
void write_distances_csv(std::ostream& out, const DistanceTable& table);

/// Writes the distances of the vertices as 32-bit floats: GIFTI, with an array for each row, or FreeSurfer's values, of
/// the first row. `faces`: of the mesh.
void write_distances_gifti(std::ostream& out, const DistanceTable& table);
void write_distances_freesurfer(std::ostream& out, const DistanceTable& table, std::int32_t faces);

/// Writes a line for each point of each path, with the columns path, source, target, length, face, b0, b1, b2, x, y, z,
/// source_vertex and target_vertex.
void write_paths_csv(std::ostream& out, const DistanceTable& table);

/// Writes the positions of one path: an array of doubles of the shape (points, 3), or vertices and a line through them,
/// which one of them has not.
void write_polyline_npy(std::ostream& out, const std::vector<Vec3>& positions);
void write_polyline_obj(std::ostream& out, const std::vector<Vec3>& positions);

/// Writes all of it as `gvd-distance/1` (docs/schema). Infinity is null.
void write_distances_json(std::ostream& out, const Mesh& mesh, const DistanceTable& table);

/// Paths and isolines as polylines with the names path_0, path_1, ... and isoline_LEVEL. A path of one point has none.
std::vector<MeshCurve> make_curves(const Mesh& mesh, const DistanceTable& table);

}  // namespace gvd
