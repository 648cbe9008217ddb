// Writes points on a surface as PLY, XYZ and NPY (version 1.0 of NumPy's format).
//
// PLY and NPY hold the same numbers in the same order; XYZ holds only positions and normals. In NPY the face is a
// double, because an array has only one type.
// Invariant: numbers have all their digits, so the same doubles are read back, in any locale.
#include "gvd/io/point_writer.hpp"

#include <array>
#include <cstdint>
#include <string>

#include "gvd/surface_point.hpp"
#include "io/writers/byte_writer.hpp"
#include "io/writers/format_writers.hpp"

namespace gvd {
namespace {

using io::ByteWriter;

/// Position and normal.
std::array<double, 6> oriented_position(const Mesh& mesh, const SurfacePoint& point) {
  const Vec3 p = position(mesh, point), n = surface_normal(mesh, point);
  return {p.x(), p.y(), p.z(), n.x(), n.y(), n.z()};
}

/// Writes the twelve numbers of a sample; `face` is the id of its face in the type of the format.
template <class Number>
void write_columns(ByteWriter& out, const Mesh& mesh, const SurfaceSample& sample, Number face) {
  for (const double value : oriented_position(mesh, sample.point)) out.binary(value);
  out.binary(face);
  for (const double b : sample.point.bary) out.binary(b);
  out.binary(sample.area);
  out.binary(sample.energy);
}

void write_ply(ByteWriter& out, const Mesh& mesh, const std::vector<SurfaceSample>& samples) {
  out.print("ply\nformat binary_little_endian 1.0\nelement vertex {}\n", samples.size());
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz"}) out.print("property double {}\n", name);
  out.text("property int face\n");
  for (const char* name : {"b0", "b1", "b2", "area", "energy"}) out.print("property double {}\n", name);
  out.text("end_header\n");
  for (const SurfaceSample& sample : samples) {
    write_columns(out, mesh, sample, sample.point.face.value());
  }
}

void write_xyz(ByteWriter& out, const Mesh& mesh, const std::vector<SurfaceSample>& samples) {
  for (const SurfaceSample& sample : samples) {
    out.print("{}\n", fmt::join(oriented_position(mesh, sample.point), " "));
  }
}

void write_npy(ByteWriter& out, const Mesh& mesh, const std::vector<SurfaceSample>& samples) {
  out.text(io::npy_header("<f8", {samples.size(), 12}));
  for (const SurfaceSample& sample : samples) {
    write_columns(out, mesh, sample, double(sample.point.face.value()));
  }
}

}  // namespace

void write_points(std::ostream& out, const Mesh& mesh, const std::vector<SurfaceSample>& samples, PointFormat format) {
  constexpr std::array kPointWriters{write_ply, write_xyz, write_npy};  // in the order of PointFormat
  static_assert(static_cast<std::size_t>(PointFormat::npy) + 1 == kPointWriters.size());
  ByteWriter writer(out);
  kPointWriters[static_cast<std::size_t>(format)](writer, mesh, samples);
  writer.finish();
}

}  // namespace gvd
