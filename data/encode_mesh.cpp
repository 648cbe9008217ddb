#include "encode_mesh.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <iterator>

namespace gvd::data {
namespace {

/// Rounded to six decimals; adding zero turns -0 into 0.
double rounded(double x) { return std::round(x * 1e6) / 1e6 + 0.0; }

Vec3 rounded(const Vec3& p) { return {rounded(p.x()), rounded(p.y()), rounded(p.z())}; }

void append_bytes(std::string& out, std::uint32_t bits, int bytes = 4) {
  for (int i = 0; i < bytes; ++i) out.push_back(static_cast<char>(bits >> (8 * i) & 0xffU));
}

void append_floats(std::string& out, const Vec3& p) {
  for (const double x : {p.x(), p.y(), p.z()}) append_bytes(out, std::bit_cast<std::uint32_t>(static_cast<float>(x)));
}

}  // namespace

std::string encode_obj(const Mesh& mesh, const std::string& comment) {
  std::string out = fmt::format("# {}\n", comment);
  for (const Vec3& p : mesh.positions()) {
    const Vec3 r = rounded(p);
    fmt::format_to(std::back_inserter(out), "v {:.6f} {:.6f} {:.6f}\n", r.x(), r.y(), r.z());
  }
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto& [a, b, c] = mesh.vertices(FaceId(f));
    fmt::format_to(std::back_inserter(out), "f {} {} {}\n", a.value() + 1, b.value() + 1, c.value() + 1);
  }
  return out;
}

std::string encode_off(const Mesh& mesh, const std::string& comment) {
  std::string out = fmt::format("OFF\n# {}\n{} {} 0\n", comment, mesh.vertex_count(), mesh.face_count());
  for (const Vec3& p : mesh.positions()) {
    const Vec3 r = rounded(p);
    fmt::format_to(std::back_inserter(out), "{:.6f} {:.6f} {:.6f}\n", r.x(), r.y(), r.z());
  }
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto& [a, b, c] = mesh.vertices(FaceId(f));
    fmt::format_to(std::back_inserter(out), "3 {} {} {}\n", a.value(), b.value(), c.value());
  }
  return out;
}

std::string encode_binary_ply(const Mesh& mesh, const std::string& comment) {
  std::string out = fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment {}\nelement vertex {}\nproperty float x\nproperty float y\n"
      "property float z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
      comment, mesh.vertex_count(), mesh.face_count());
  for (const Vec3& p : mesh.positions()) append_floats(out, rounded(p));
  for (int f = 0; f < mesh.face_count(); ++f) {
    append_bytes(out, 3, 1);
    for (const VertexId v : mesh.vertices(FaceId(f))) append_bytes(out, static_cast<std::uint32_t>(v.value()));
  }
  return out;
}

std::string encode_binary_stl(const Mesh& mesh) {
  constexpr std::size_t kHeaderBytes = 80;
  std::string out = "binary STL";
  out.resize(kHeaderBytes, ' ');
  append_bytes(out, static_cast<std::uint32_t>(mesh.face_count()));
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto& [a, b, c] = mesh.vertices(FaceId(f));
    const Vec3 &p = mesh.position(a), &q = mesh.position(b), &r = mesh.position(c);
    append_floats(out, rounded((q - p).cross(r - p).normalized()));
    for (const Vec3& corner : {p, q, r}) append_floats(out, rounded(corner));
    append_bytes(out, 0, 2);
  }
  return out;
}

}  // namespace gvd::data
