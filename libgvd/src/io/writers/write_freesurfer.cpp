// Writes FreeSurfer's own formats: surfaces of triangles, annotations of vertices, and values of vertices.
//
// An annotation identifies regions by their colours alone, so no two regions may have the same. A region whose colour
// is taken gets one nearby: the bits of a counter change bits of red, green and blue in turn, the lowest first. So 512
// regions of the same colour differ from it by at most 7 of 255.
// Source: FreeSurfer's wiki, pages FileFormats and LabelsClutsAnnotationFiles; nibabel's freesurfer.io.
// Invariant: no region has the colour 0, which stands for no region.
#include <algorithm>
#include <cstdint>
#include <set>
#include <string_view>

#include "gvd/io/distance_writer.hpp"
#include "io/writers/byte_writer.hpp"
#include "io/writers/format_writers.hpp"

namespace gvd::io {
namespace {

/// The number by which an annotation refers to the region with this colour.
std::int32_t pack(const Rgb& color) { return color.red | color.green << 8 | color.blue << 16; }

/// A variant of a colour. All steps below 2^24 give different colours, and step 0 gives the colour itself.
Rgb vary(Rgb color, std::uint32_t step) {
  for (int bit = 0; step >> bit != 0; ++bit) {
    std::uint8_t& channel = bit % 3 == 0 ? color.red : bit % 3 == 1 ? color.green : color.blue;
    channel = std::uint8_t(channel ^ (step >> bit & 1) << (bit / 3));
  }
  return color;
}

void separate_colors(std::vector<NumberedLabel>& table) {
  std::set<std::int32_t> taken{0};
  for (NumberedLabel& label : table) {
    const Rgb wanted = label.color;
    for (std::uint32_t step = 1; !taken.insert(pack(label.color)).second; ++step) label.color = vary(wanted, step);
  }
}

/// Writes the length of a text, including the zero at its end, and then the text.
void write_text(ByteWriter& out, std::string_view text) {
  out.big_endian(std::int32_t(text.size() + 1));
  out.text(text);
  out.append("", 1);
}

}  // namespace

void write_freesurfer_surface(std::ostream& stream, const ColoredMesh& labelled) {
  const Mesh& mesh = labelled.mesh;
  ByteWriter out(stream);
  out.text("\xff\xff\xfe");
  out.text("created by gvd\n\n");
  out.big_endian(mesh.vertex_count());
  out.big_endian(mesh.face_count());
  for (const Vec3& p : mesh.positions()) {
    for (int i = 0; i < 3; ++i) out.big_endian(static_cast<float>(p[i]));
  }
  for (const FaceId f : mesh.faces()) {
    for (const VertexId v : mesh.vertices(f)) out.big_endian(v.value());
  }
  out.finish();
}

void write_annotation(std::ostream& stream, const ColoredMesh& labelled) {
  std::vector<NumberedLabel> table = number_labels(labelled, ".annot");
  separate_colors(table);
  ByteWriter out(stream);
  out.big_endian(std::int32_t(labelled.vertex_label->size()));
  for (const VertexId v : labelled.vertex_label->ids()) {
    out.big_endian(v.value());
    out.big_endian(pack(table[std::size_t(label_number((*labelled.vertex_label)[v]))].color));
  }
  out.big_endian(std::int32_t{1});   // a table follows
  out.big_endian(std::int32_t{-2});  // the table has version 2
  out.big_endian(std::int32_t(table.size()));
  write_text(out, "gvd");  // the name of the table's file
  out.big_endian(std::int32_t(table.size()));
  for (const auto& [number, name, color] : table) {
    out.big_endian(number);
    write_text(out, name);
    for (const std::uint8_t channel : {color.red, color.green, color.blue, std::uint8_t{0}}) {
      out.big_endian(std::int32_t{channel});
    }
  }
  out.finish();
}

void write_freesurfer_distances(std::ostream& stream, const ColoredMesh& labelled) {
  write_distances_freesurfer(stream, require_distances(labelled, ".curv"), labelled.mesh.face_count());
}

}  // namespace gvd::io

namespace gvd {

void write_distances_freesurfer(std::ostream& stream, const DistanceTable& table, std::int32_t faces) {
  const std::span<const double> row = table.rows[0];
  io::ByteWriter out(stream);
  out.text("\xff\xff\xff");
  out.big_endian(std::int32_t(row.size()));
  out.big_endian(faces);
  out.big_endian(std::int32_t{1});  // one value for each vertex
  for (const double distance : row) out.big_endian(static_cast<float>(distance));
  out.finish();
}

}  // namespace gvd
