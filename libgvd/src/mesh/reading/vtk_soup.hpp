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

/// Cells of VTK as a file gives them: nothing is checked. Doubles hold every index that a mesh may have.
struct VtkCells {
  std::vector<double> ends;     ///< per cell: the number of corners of all cells up to this one
  std::vector<double> corners;  ///< of all cells, one after the other: points, counted from the piece's first
};

/// The type of a name such as "Float32", of XML, or "unsigned_int", of legacy files. None for any other name.
std::optional<StoredNumber> find_vtk_type(std::string_view name);

/// A soup from points and cells of VTK, piece by piece. Errors are Error{unreadable_input}, or Error{precondition} for
/// coordinates that are not finite and for too many elements; all name the file.
class VtkSoup {
 public:
  explicit VtkSoup(std::string_view name) : name_(name) {}

  /// Begins a piece with its points: three coordinates each.
  void add_points(const std::vector<double>& coordinates);
  void add_polygons(const VtkCells& cells) { for_each_cell(cells, &VtkSoup::add_polygon); }
  /// Strips of triangles.
  void add_strips(const VtkCells& cells) { for_each_cell(cells, &VtkSoup::add_strip); }
  /// Leaves out vertices and lines, and at the end the points that only they have.
  void leave_out(const VtkCells& cells) { for_each_cell(cells, &VtkSoup::leave_out_cell); }
  /// Says that the file has texture coordinates, which are not read.
  void leave_out_texture() { soup_.appearance.unread.assign(1, kUnreadTexture); }
  /// Cells of an unstructured grid: `types` says what each one is. Those with a volume are refused.
  void add_cells(const VtkCells& cells, const std::vector<double>& types);

  PolygonSoup take();
  /// Number of cells so far, of all pieces, also those left out.
  std::int64_t cell_count() const { return cell_; }
  /// From now on, `polygon_cells` grows.
  void keep_cells() { keeps_cells_ = true; }
  /// The cell of each polygon, in the order in which they were added.
  const std::vector<std::int64_t>& polygon_cells() const { return polygon_cell_; }
  /// Whether each point that was added is a position of the soup that `take` returned; empty where all are.
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
  const double* type_ = nullptr;  // of the next cell of an unstructured grid
  std::int64_t left_out_ = 0;
  std::vector<std::int32_t> line_points_;
  bool keeps_cells_ = false;
  std::vector<std::int64_t> polygon_cell_;
  std::vector<char> is_kept_;
};

}  // namespace gvd
