#pragma once

#include <cstring>
#include <string>
#include <string_view>

#include "gvd/error.hpp"
#include "gvd/soup.hpp"
#include "support/catch.hpp"

namespace gvd::test {

// One tetrahedron of edge sqrt(2) in every format.

inline const std::string kObj =
    "# a tetrahedron\nv 0 0 0\nv 1 1 0\nv 1 0 1\nv 0 1 1\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n";

inline const std::string kOff = "OFF\n4 4 6\n0 0 0\n1 1 0\n1 0 1\n0 1 1\n3 0 1 2\n3 0 3 1\n3 0 2 3\n3 1 3 2\n";

inline const std::string kPly =
    "ply\nformat ascii 1.0\ncomment a tetrahedron\nelement vertex 4\nproperty float x\nproperty float y\nproperty "
    "float z\n"
    "element face 4\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 1 0\n1 0 1\n0 1 1\n3 0 1 2\n3 0 3 1\n3 0 2 3\n3 1 3 2\n";

inline const std::string kStl =
    "solid tetrahedron\n"
    "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 1 0\nvertex 1 0 1\nendloop\nendfacet\n"
    "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 0 1 1\nvertex 1 1 0\nendloop\nendfacet\n"
    "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 1\nvertex 0 1 1\nendloop\nendfacet\n"
    "facet normal 0 0 0\nouter loop\nvertex 1 1 0\nvertex 0 1 1\nvertex 1 0 1\nendloop\nendfacet\n"
    "endsolid tetrahedron\n";

/// The bytes of a number, the lowest first or last.
template <class T>
std::string bytes_of(T value, bool big_endian = false) {
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  const std::uint16_t one = 1;
  char low = 0;
  std::memcpy(&low, &one, 1);
  if ((low == 0) != big_endian) bytes.assign(bytes.rbegin(), bytes.rend());
  return bytes;
}

inline std::string binary_ply(bool big_endian) {
  std::string bytes = "ply\nformat binary_" + std::string(big_endian ? "big" : "little") +
                      "_endian 1.0\nelement vertex 4\nproperty float x\nproperty double y\nproperty short z\n"
                      "element face 4\nproperty list uchar int vertex_indices\nend_header\n";
  const PolygonSoup soup = parse_soup(kOff, MeshFormat::off, "off");
  for (const Vec3& p : soup.positions) {
    bytes += bytes_of(static_cast<float>(p.x()), big_endian) + bytes_of(p.y(), big_endian) +
             bytes_of(static_cast<std::int16_t>(p.z()), big_endian);
  }
  for (std::size_t f = 0; f < 4; ++f) {
    bytes += '\3';
    for (const std::int32_t v : soup.polygon(f)) bytes += bytes_of(v, big_endian);
  }
  return bytes;
}

inline std::string binary_stl() {
  std::string bytes(80, ' ');
  bytes += bytes_of(std::uint32_t{4});
  const PolygonSoup soup = parse_soup(kOff, MeshFormat::off, "off");
  for (std::size_t f = 0; f < 4; ++f) {
    bytes += std::string(12, '\0');
    for (const std::int32_t v : soup.polygon(f)) {
      for (const double x : soup.positions[v]) bytes += bytes_of(static_cast<float>(x));
    }
    bytes += std::string(2, '\0');
  }
  return bytes;
}

/// Reads `bytes` and requires an error with this code whose message holds `part` and is one line.
inline void require_refused(std::string_view bytes, MeshFormat format, const std::string& part,
                            ErrorCode code = ErrorCode::unreadable_input) {
  try {
    parse_soup(bytes, format, "file");
    FAIL("read, expected: " << part);
  } catch (const Error& error) {
    CHECK_THAT(error.what(), Catch::Matchers::Contains(part));
    CHECK(error.code() == code);
    CHECK(std::string(error.what()).find('\n') == std::string::npos);
  }
}

/// Requires that the soup is the tetrahedron, with or without welded vertices.
inline void require_tetrahedron(const PolygonSoup& soup) {
  REQUIRE(soup.polygon_count() == 4);
  const CheckedMesh checked = build_mesh(soup);
  REQUIRE(checked.mesh.vertex_count() == 4);
  REQUIRE(compute_mesh_summary(checked.mesh).euler_characteristic == 2);
  REQUIRE(checked.mesh.position(VertexId(1)) == Vec3(1, 1, 0));
}

}  // namespace gvd::test
