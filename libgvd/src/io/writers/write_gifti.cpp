// Writes GIFTI: surfaces, labels and distances of vertices, for programs that show and measure brains.
//
// Arrays are in Base64 and not compressed, because the bytes of compressed arrays depend on zlib's version. The only
// real numbers of the standard are 32-bit floats. A vertex has the key of its label in the table of labels; key 0 is
// transparent, as ??? is in the files of other programs.
// Source: GIFTI Surface Data Format, version 1.0 (January 2011); Workbench for the names ??? and SHAPE.
#include <cstdint>
#include <string_view>
#include <type_traits>

#include "gvd/io/distance_writer.hpp"
#include "io/writers/byte_writer.hpp"
#include "io/writers/format_writers.hpp"

namespace gvd::io {
namespace {

void open_gifti(ByteWriter& out, std::size_t arrays) {
  out.print(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<!DOCTYPE GIFTI SYSTEM \"http://www.nitrc.org/frs/download.php/115/gifti.dtd\">\n"
      "<GIFTI Version=\"1.0\" NumberOfDataArrays=\"{}\">\n<MetaData/>\n",
      arrays);
}

void close_gifti(ByteWriter& out) {
  out.text("</GIFTI>\n");
  out.finish();
}

struct GiftiArray {
  std::string_view intent;
  std::size_t rows;
  int columns = 1;
  std::string_view transform = {};
};

/// Writes one DataArray with the numbers that `fill` passes to its argument.
template <class T, class Fill>
void write_gifti_array(ByteWriter& out, const GiftiArray& array, Fill fill) {
  out.print(
      "<DataArray Intent=\"NIFTI_INTENT_{}\" DataType=\"NIFTI_TYPE_{}\" ArrayIndexingOrder=\"RowMajorOrder\" "
      "Dimensionality=\"{}\" Dim0=\"{}\"{} Encoding=\"Base64Binary\" Endian=\"LittleEndian\" "
      "ExternalFileName=\"\" ExternalFileOffset=\"\">\n<MetaData/>\n{}<Data>",
      array.intent, std::is_floating_point_v<T> ? "FLOAT32" : "INT32", array.columns > 1 ? 2 : 1, array.rows,
      array.columns > 1 ? fmt::format(" Dim1=\"{}\"", array.columns) : "", array.transform);
  Base64Writer base64(out);
  fill([&base64](T value) { base64.binary(value); });
  base64.finish();
  out.text("</Data>\n</DataArray>\n");
}

/// Readers expect a transform of the points. This is the identity between two unknown spaces.
constexpr std::string_view kIdentity =
    "<CoordinateSystemTransformMatrix>\n<DataSpace><![CDATA[NIFTI_XFORM_UNKNOWN]]></DataSpace>\n"
    "<TransformedSpace><![CDATA[NIFTI_XFORM_UNKNOWN]]></TransformedSpace>\n"
    "<MatrixData>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</MatrixData>\n</CoordinateSystemTransformMatrix>\n";

}  // namespace

void write_gifti_surface(std::ostream& stream, const ColoredMesh& labelled) {
  const Mesh& mesh = labelled.mesh;
  ByteWriter out(stream);
  open_gifti(out, 2);
  write_gifti_array<float>(out, {"POINTSET", mesh.positions().size(), 3, kIdentity}, [&](auto put) {
    for (const Vec3& p : mesh.positions()) {
      for (int i = 0; i < 3; ++i) put(static_cast<float>(p[i]));
    }
  });
  write_gifti_array<std::int32_t>(out, {"TRIANGLE", std::size_t(mesh.face_count()), 3}, [&](auto put) {
    for (const FaceId f : mesh.faces()) {
      for (const VertexId v : mesh.vertices(f)) put(v.value());
    }
  });
  close_gifti(out);
}

void write_gifti_labels(std::ostream& stream, const ColoredMesh& labelled) {
  const std::vector<NumberedLabel> table = number_labels(labelled, ".label.gii");
  ByteWriter out(stream);
  open_gifti(out, 1);
  out.text("<LabelTable>\n");
  for (const auto& [number, name, color] : table) {
    out.print("<Label Key=\"{}\" Red=\"{}\" Green=\"{}\" Blue=\"{}\" Alpha=\"{}\"><![CDATA[{}]]></Label>\n", number,
              color.red / 255.0, color.green / 255.0, color.blue / 255.0, number == 0 ? 0 : 1, name);
  }
  out.text("</LabelTable>\n");
  write_gifti_array<std::int32_t>(out, {"LABEL", labelled.vertex_label->size()}, [&](auto put) {
    for (const GeneratorId label : *labelled.vertex_label) put(label_number(label));
  });
  close_gifti(out);
}

void write_gifti_distances(std::ostream& stream, const ColoredMesh& labelled) {
  write_distances_gifti(stream, require_distances(labelled, ".shape.gii"));
}

}  // namespace gvd::io

namespace gvd {

void write_distances_gifti(std::ostream& stream, const DistanceTable& table) {
  io::ByteWriter out(stream);
  io::open_gifti(out, table.rows.size());
  for (const std::span<const double> row : table.rows.each()) {
    io::write_gifti_array<float>(out, {"SHAPE", row.size()}, [&](auto put) {
      for (const double distance : row) put(static_cast<float>(distance));
    });
  }
  io::close_gifti(out);
}

}  // namespace gvd
