#pragma once

#include <compare>
#include <cstdint>
#include <limits>
#include <vector>

#include "geodesic/marching/local_march.hpp"
#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// How far a cell is from a disc.
int count_disc_defects(const Cell& cell);

/// Forecasts from the labels of vertices how many cells would be discs with one more generator.
///
/// A march from the point finds the vertices that would be nearest to it. A cell stands for its vertices, and the edges
/// and faces between them. If the mesh is fine enough, these have the cell's Euler characteristic; a cell for which it
/// is too coarse does not count. A forecast takes time in proportion to the new cell. The diagram of a part takes time
/// in proportion to two rings of cells, which are the whole mesh if there are few cells.
class DiscForecast {
 public:
  /// The mesh must outlive this. Cost: O(n); memory: about 150 bytes a face.
  explicit DiscForecast(const Mesh& mesh);

  /// Takes this diagram of the mesh, which must outlive the calls of `find`. Cost: O(n).
  void take(const Diagram& diagram);

  /// Whether the vertices of this cell have its Euler characteristic, so that a forecast can tell what becomes of it.
  bool tells(GeneratorId cell) const { return tells_[cell] != 0; }

  /// The changes that one more generator would make. The least is best.
  struct Outcome {
    int defects = 0;  ///< `count_disc_defects` of all cells: below 0 for fewer
    /// The change in the sum of their squares: below 0 if a cell with several is divided into cells with one each.
    int squares = 0;
    int imbalance = 0;  ///< difference in the numbers of vertices of the cell and the new one
    auto operator<=>(const Outcome&) const = default;
  };
  static constexpr Outcome kWorst{std::numeric_limits<int>::max(), 0, 0};
  /// For a point that is to divide a cell. Cost: O(k log k) for the k vertices of its own cell.
  Outcome find(const SurfacePoint& point, GeneratorId divided);

 private:
  struct Change {
    GeneratorId cell;
    int euler = 0;
  };
  GeneratorId label_after(VertexId v) const { return is_moved_[v] == run_ ? new_cell_ : diagram_->vertex_label[v]; }
  void add(GeneratorId cell, int euler);
  void replace_around(VertexId v);
  void replace(const std::vector<VertexId>& corners, int sign);

  const Mesh& mesh_;
  LocalMarch march_;
  const Diagram* diagram_ = nullptr;
  IdVector<PlaceId, double> distance_;
  IdVector<GeneratorId, std::int32_t> euler_;  // of the vertices of each cell, with edges and faces between them
  IdVector<GeneratorId, std::int32_t> vertices_;
  IdVector<GeneratorId, char> tells_;
  GeneratorId new_cell_;
  std::int32_t run_ = 0;
  IdVector<VertexId, std::int32_t> is_moved_;  // the last run in which the vertex would change its cell
  IdVector<FaceId, std::int32_t> is_counted_;  // the last run in which the face was counted
  std::vector<Change> changes_;
};

}  // namespace gvd
