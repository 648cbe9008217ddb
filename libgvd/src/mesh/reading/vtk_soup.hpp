#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gvd/polygon_soup.hpp"
#include "mesh/reading/stored_numbers.hpp"

namespace gvd {

/// Cells of VTK as read from a file, unchecked. Doubles can hold every index of a mesh.
struct VtkCells {
  std::vector<double> ends;     ///< per cell: the number of corners of all cells up to this one
  std::vector<double> corners;  ///< of all cells, one after the other: numbers of points within the piece
};

/// Finds a type by its name in XML ("Float32") or in legacy files ("unsigned_int"). Returns nothing for any other name.
std::optional<StoredNumber> find_vtk_type(std::string_view name);

/// Builds a soup from VTK's points and cells, piece by piece. Throws Error{unreadable_input}, or Error{precondition}
/// for coordinates that are not finite and for too many elements; messages name the file.
class VtkSoup {
 public:
  explicit VtkSoup(std::string_view name) : name_(name) {}

  /// Begins a piece with its points, three coordinates each.
  void add_points(const std::vector<double>& coordinates);
  void add_polygons(const VtkCells& cells) { for_each_cell(cells, &VtkSoup::add_polygon); }
  /// Adds the triangles of strips.
  void add_strips(const VtkCells& cells) { for_each_cell(cells, &VtkSoup::add_strip); }
  /// Leaves out vertices and lines, and in the end the points that only they use.
  void leave_out(const VtkCells& cells) { for_each_cell(cells, &VtkSoup::leave_out_cell); }
  /// Notes that the file has texture coordinates, which are not read.
  void leave_out_texture() { soup_.appearance.unread.assign(1, kUnreadTexture); }
  /// Adds the cells of an unstructured grid; `types` has the type of each cell. Refuses cells with a volume.
  void add_cells(const VtkCells& cells, const std::vector<double>& types);

  PolygonSoup take();
  /// Number of cells so far in all pieces, including the cells that were left out.
  std::int64_t cell_count() const { return cell_; }
  /// From now on, records the cell of each polygon in `polygon_cells`.
  void keep_cells() { keeps_cells_ = true; }
  /// The cell of each polygon, in the order in which they were added.
  const std::vector<std::int64_t>& polygon_cells() const { return polygon_cell_; }
  /// For each added point, whether it is a position of the soup that `take` returned; empty if all are.
  const std::vector<char>& kept_points() const { return is_kept_; }
  [[noreturn]] void refuse(std::string_view message, std::int64_t element = -1) const;

 private:
  using Corners = std::span<const double>;

  void for_each_cell(const VtkCells& cells, void (VtkSoup::*add)(Corners));
  void add_polygon(Corners corners);
  void add_strip(Corners corners);
  void leave_out_cell(Corners corners);
  void add_typed(Corners corners);
  std::int32_t require_index(double corner) const;
  void drop_points_of_lines();

  std::string name_;
  PolygonSoup soup_;
  std::size_t first_point_ = 0;   // of the piece
  std::int64_t cell_ = 0;         // number of cells so far
  const double* type_ = nullptr;  // type of the next cell of an unstructured grid
  std::int64_t left_out_ = 0;
  std::vector<std::int32_t> line_points_;
  bool keeps_cells_ = false;
  std::vector<std::int64_t> polygon_cell_;
  std::vector<char> is_kept_;
};

}  // namespace gvd
