// Writes VTK's PolyData and UnstructuredGrid in XML, with arrays in Base64 (VTK File Formats, version 4.2).
//
// The points are the vertices of the mesh, followed by the points of the bisectors and curves. The cells of PolyData
// are the bisectors and curves as lines, then the faces, because VTK numbers lines before polygons. For meshio, which
// reads neither PolyData nor lines of more than two points, an UnstructuredGrid has the faces first and then the single
// segments of the lines. Each array is encoded number by number, so no array is copied in memory. Its length in bytes
// comes first.
// Invariant: an array has one value for each point or cell in that order, and -1 for an element without a value.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "io/writers/byte_writer.hpp"
#include "io/writers/format_writers.hpp"

namespace gvd::io {
namespace {

/// Writes one DataArray: the number of its bytes as UInt64, then the numbers that `fill` passes to its argument.
template <class T, class Fill>
void write_array(ByteWriter& out, std::string_view name, std::size_t size, int components, Fill fill) {
  const char* const kind = std::is_floating_point_v<T> ? "Float" : std::is_unsigned_v<T> ? "UInt" : "Int";
  // Written only for several components, because meshio makes a matrix of an array that declares one.
  const std::string several = components > 1 ? fmt::format(" NumberOfComponents=\"{}\"", components) : "";
  out.print("<DataArray type=\"{}{}\" Name=\"{}\"{} format=\"binary\">\n", kind, 8 * sizeof(T), name, several);
  Base64Writer base64(out);
  base64.binary(static_cast<std::uint64_t>(size * sizeof(T)));
  fill([&base64](T value) { base64.binary(value); });
  base64.finish();
  out.text("\n</DataArray>\n");
}

/// A line, or one of its segments.
struct LineCell {
  const OutputLine* line;
  std::int64_t first;  ///< number of its first point
  std::int64_t size;   ///< number of consecutive points
};

constexpr std::uint8_t kLineType = 3, kTriangleType = 5;  // VTKCellType

class VtkWriter {
 public:
  VtkWriter(std::ostream& out, const LabelledMesh& labelled)
      : out_(out), labelled_(labelled), mesh_(labelled.mesh), lines_(collect_lines(labelled)) {
    for (const OutputLine& line : lines_) line_points_ += line.points.size();
  }

  void write_poly_data() {
    std::int64_t first = std::ssize(mesh_.positions());
    for (const OutputLine& line : lines_) {
      line_cells_.push_back({&line, first, std::ssize(line.points)});
      first += std::ssize(line.points);
    }
    print_head("PolyData");
    out_.print(
        "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"{}\" NumberOfStrips=\"0\" "
        "NumberOfPolys=\"{}\">\n",
        vertices() + line_points_, line_cells_.size(), faces());
    write_data(Part::lines, Part::faces);
    write_cells("Lines", Part::lines, Part::none);
    write_cells("Polys", Part::faces, Part::none);
    print_tail("PolyData");
  }

  void write_unstructured_grid() {
    std::int64_t first = std::ssize(mesh_.positions());
    for (const OutputLine& line : lines_) {
      for (std::size_t i = 1; i < line.points.size(); ++i) line_cells_.push_back({&line, first++, 2});
      ++first;
    }
    print_head("UnstructuredGrid");
    out_.print("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n", vertices() + line_points_,
               line_cells_.size() + faces());
    write_data(Part::faces, Part::lines);
    write_cells("Cells", Part::faces, Part::lines);
    print_tail("UnstructuredGrid");
  }

 private:
  enum class Part { none, lines, faces };

  void print_head(std::string_view type) {
    out_.print(
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"{0}\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<{0}>\n",
        type);
  }
  void print_tail(std::string_view type) {
    out_.print("</Piece>\n</{}>\n</VTKFile>\n", type);
    out_.finish();
  }

  void write_data(Part first, Part second) {
    order_ = {first, second};
    write_point_data();
    write_cell_data();
    write_points();
  }

  std::size_t vertices() const { return mesh_.positions().size(); }
  std::size_t faces() const { return static_cast<std::size_t>(mesh_.face_count()); }

  void write_point_data() {
    out_.text(labelled_.vertex_distance != nullptr ? "<PointData Scalars=\"Distance\">\n" : "<PointData>\n");
    if (labelled_.vertex_distance != nullptr) {
      write_array<double>(out_, "Distance", vertices() + line_points_, 1, [&](auto put) {
        for (const double distance : *labelled_.vertex_distance) put(distance);
        for (const OutputLine& line : lines_) {
          for (const double distance : line.distance) put(distance);
        }
      });
    }
    if (labelled_.vertex_label != nullptr) {
      write_array<std::int32_t>(out_, "Label", vertices() + line_points_, 1, [&](auto put) {
        for (const GeneratorId label : *labelled_.vertex_label) put(label.value());
        for (std::size_t i = 0; i < line_points_; ++i) put(-1);
      });
    }
    out_.text("</PointData>\n");
  }

  /// Calls `of_line` or `of_face` for each cell of these parts in turn.
  template <class OfLine, class OfFace>
  void visit_cells(const std::array<Part, 2>& parts, OfLine of_line, OfFace of_face) const {
    for (const Part part : parts) {
      if (part == Part::lines) std::for_each(line_cells_.begin(), line_cells_.end(), of_line);
      if (part == Part::faces) std::ranges::for_each(mesh_.faces(), of_face);
    }
  }

  /// Writes an array with one value for each cell, which `of_line` or `of_face` returns.
  template <class OfLine, class OfFace>
  void write_cell_array(std::string_view name, OfLine of_line, OfFace of_face) {
    write_array<std::int32_t>(out_, name, line_cells_.size() + faces(), 1, [&](auto put) {
      visit_cells(
          order_, [&](const LineCell& cell) { put(of_line(*cell.line)); }, [&](FaceId f) { put(of_face(f)); });
    });
  }

  void write_cell_data() {
    const auto none = [](const auto&) { return std::int32_t{-1}; };
    out_.text(labelled_.face_label != nullptr ? "<CellData Scalars=\"Label\">\n" : "<CellData>\n");
    if (labelled_.face_label != nullptr) {
      write_cell_array("Label", none, [&](FaceId f) { return (*labelled_.face_label)[f].value(); });
    }
    if (labelled_.face_parent != nullptr) {
      write_cell_array("Parent", none, [&](FaceId f) { return (*labelled_.face_parent)[f].value(); });
    }
    if (labelled_.face_numbers != nullptr) {
      for (const FaceNumbers& numbers : *labelled_.face_numbers) {
        write_cell_array(numbers.name, none, [&](FaceId f) { return numbers.values[f]; });
      }
    }
    if (labelled_.diagram != nullptr && !labelled_.no_bisectors) {
      write_cell_array(
          "Left", [](const OutputLine& line) { return line.left.value(); }, none);
      write_cell_array(
          "Right", [](const OutputLine& line) { return line.right.value(); }, none);
    }
    if (labelled_.curves != nullptr) {
      const std::ptrdiff_t bisectors = std::ssize(lines_) - std::ssize(*labelled_.curves);
      write_cell_array(
          "Curve",
          [&](const OutputLine& line) {
            return static_cast<std::int32_t>(std::max<std::ptrdiff_t>(-1, &line - lines_.data() - bisectors));
          },
          none);
    }
    out_.text("</CellData>\n");
  }

  void write_points() {
    out_.text("<Points>\n");
    write_array<double>(out_, "Points", 3 * (vertices() + line_points_), 3, [&](auto put) {
      const auto put_point = [&put](const Vec3& p) {
        for (int i = 0; i < 3; ++i) put(p[i]);
      };
      for (const Vec3& p : mesh_.positions()) put_point(p);
      for (const OutputLine& line : lines_) {
        for (const Vec3& p : line.points) put_point(p);
      }
    });
    out_.text("</Points>\n");
  }

  /// Writes the points of the cells in these parts, where each cell ends and, for a grid, the type of each cell.
  void write_cells(std::string_view name, Part first, Part second) {
    const std::array<Part, 2> parts{first, second};
    std::size_t count = 0, corners = 0;
    visit_cells(
        parts, [&](const LineCell& cell) { ++count, corners += std::size_t(cell.size); },
        [&](FaceId) { ++count, corners += 3; });
    out_.print("<{}>\n", name);
    write_array<std::int64_t>(out_, "connectivity", corners, 1, [&](auto put) {
      visit_cells(
          parts,
          [&](const LineCell& cell) {
            for (std::int64_t i = 0; i < cell.size; ++i) put(cell.first + i);
          },
          [&](FaceId f) {
            for (const VertexId v : mesh_.vertices(f)) put(v.value());
          });
    });
    write_array<std::int64_t>(out_, "offsets", count, 1, [&](auto put) {
      std::int64_t end = 0;
      visit_cells(
          parts, [&](const LineCell& cell) { put(end += cell.size); }, [&](FaceId) { put(end += 3); });
    });
    if (name == "Cells") {
      write_array<std::uint8_t>(out_, "types", count, 1, [&](auto put) {
        visit_cells(
            parts, [&](const LineCell&) { put(kLineType); }, [&](FaceId) { put(kTriangleType); });
      });
    }
    out_.print("</{}>\n", name);
  }

  ByteWriter out_;
  const LabelledMesh& labelled_;
  const Mesh& mesh_;
  std::vector<OutputLine> lines_;
  std::vector<LineCell> line_cells_;
  std::size_t line_points_ = 0;
  std::array<Part, 2> order_{};
};

}  // namespace

void write_vtp(std::ostream& stream, const ColoredMesh& mesh) { VtkWriter(stream, mesh).write_poly_data(); }

void write_vtu(std::ostream& stream, const ColoredMesh& mesh) { VtkWriter(stream, mesh).write_unstructured_grid(); }

}  // namespace gvd::io
