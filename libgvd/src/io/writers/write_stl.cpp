// Writes binary STL: 80 bytes of header, the number of triangles, and 50 bytes for each triangle, with its normal, its
// corners and an attribute. Readers tell it from text by its length. STL has neither shared vertices nor labels. The
// colour of a label goes into the attribute, by the convention of VisCAM and SolidView that most programs read.
// Source: 3D Systems' StereoLithography Interface Specification, for all but the colours.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "io/writers/byte_writer.hpp"
#include "io/writers/format_writers.hpp"

namespace gvd::io {
namespace {

/// The header of an STL must not begin with "solid", or readers would take the file for text.
constexpr std::string_view kHeader = "binary STL, 32-bit floats, face colours in the attribute";
constexpr std::size_t kHeaderBytes = 80;

/// The attribute of a face by its colour: bit 15 is set, then 5 bits each of red, green and blue.
std::uint16_t attribute(const Rgb& color) {
  return std::uint16_t(0x8000 | (color.red >> 3) << 10 | (color.green >> 3) << 5 | color.blue >> 3);
}

}  // namespace

void write_stl(std::ostream& stream, const ColoredMesh& labelled) {
  const Mesh& mesh = labelled.mesh;
  ByteWriter out(stream);
  std::string header(kHeader);
  header.resize(kHeaderBytes, ' ');
  out.text(header);
  out.binary(std::uint32_t(mesh.face_count()));
  for (const FaceId f : mesh.faces()) {
    const auto& [a, b, c] = mesh.vertices(f);
    const Vec3& origin = mesh.position(a);
    // The edges are normalized first, because the product of two short edges can underflow. A face without area gets
    // the normal 0.
    const Vec3 u = (mesh.position(b) - origin).stableNormalized();
    const Vec3 v = (mesh.position(c) - origin).stableNormalized();
    out.floats(u.cross(v).normalized());
    for (const VertexId corner : {a, b, c}) out.floats(mesh.position(corner));
    out.binary(labelled.face_label != nullptr ? attribute(labelled.color((*labelled.face_label)[f]))
                                              : std::uint16_t{0});
  }
  out.finish();
}

}  // namespace gvd::io
