// VTK PolyData in XML, with arrays in Base64 (VTK File Formats, version 4.2).
//
// Points are the vertices of the mesh, then those of the bisectors and curves. Cells are these as lines, then the
// faces: VTK numbers lines before polygons. Each array is encoded number by number, so none is held in memory a second
// time. Its length comes first, in bytes. Invariant: an array has one value for each point or cell in that order, and
// -1 where an element has none.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>

#include "io/writers/byte_writer.hpp"
#include "io/writers/format_writers.hpp"

namespace gvd::io {
namespace {

/// One DataArray: the number of its bytes as UInt64, then the numbers that `fill` passes to its argument.
template <class T, class Fill>
void write_array(ByteWriter& out, std::string_view name, std::size_t size, int components, Fill fill) {
  out.print("<DataArray type=\"{}{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"binary\">\n",
            std::is_floating_point_v<T> ? "Float" : "Int", 8 * sizeof(T), name, components);
  Base64Writer base64(out);
  base64.binary(static_cast<std::uint64_t>(size * sizeof(T)));
  fill([&base64](T value) { base64.binary(value); });
  base64.finish();
  out.text("\n</DataArray>\n");
}

class VtpWriter {
 public:
  VtpWriter(std::ostream& out, const LabelledMesh& labelled)
      : out_(out), labelled_(labelled), mesh_(labelled.mesh), lines_(collect_lines(labelled)) {
    for (const OutputLine& line : lines_) line_points_ += line.points.size();
  }

  void write() {
    out_.text(
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PolyData>\n");
    out_.print(
        "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"{}\" NumberOfStrips=\"0\" "
        "NumberOfPolys=\"{}\">\n",
        vertices() + line_points_, lines_.size(), faces());
    write_point_data();
    write_cell_data();
    write_points();
    write_lines();
    write_polygons();
    out_.text("</Piece>\n</PolyData>\n</VTKFile>\n");
    out_.finish();
  }

 private:
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

  /// One value per cell, in the order of VTK: lines, then polygons. `of_line` and `of_face` give the values.
  template <class OfLine, class OfFace>
  void write_cell_array(std::string_view name, OfLine of_line, OfFace of_face) {
    write_array<std::int32_t>(out_, name, lines_.size() + faces(), 1, [&](auto put) {
      for (const OutputLine& line : lines_) put(of_line(line));
      for (const FaceId f : mesh_.faces()) put(of_face(f));
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

  void write_lines() {
    out_.text("<Lines>\n");
    write_array<std::int64_t>(out_, "connectivity", line_points_, 1, [&](auto put) {
      for (std::size_t i = 0; i < line_points_; ++i) put(std::ssize(mesh_.positions()) + std::int64_t(i));
    });
    write_array<std::int64_t>(out_, "offsets", lines_.size(), 1, [&](auto put) {
      std::int64_t end = 0;
      for (const OutputLine& line : lines_) put(end += std::ssize(line.points));
    });
    out_.text("</Lines>\n");
  }

  void write_polygons() {
    out_.text("<Polys>\n");
    write_array<std::int64_t>(out_, "connectivity", 3 * faces(), 1, [&](auto put) {
      for (const FaceId f : mesh_.faces()) {
        for (const VertexId v : mesh_.vertices(f)) put(v.value());
      }
    });
    write_array<std::int64_t>(out_, "offsets", faces(), 1, [&](auto put) {
      for (std::int64_t f = 1; f <= mesh_.face_count(); ++f) put(3 * f);
    });
    out_.text("</Polys>\n");
  }

  ByteWriter out_;
  const LabelledMesh& labelled_;
  const Mesh& mesh_;
  std::vector<OutputLine> lines_;
  std::size_t line_points_ = 0;
};

}  // namespace

void write_vtp(std::ostream& stream, const ColoredMesh& mesh) { VtpWriter(stream, mesh).write(); }

}  // namespace gvd::io
