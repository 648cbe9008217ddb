#pragma once

#include <cstring>
#include <initializer_list>
#include <string>
#include <string_view>

#include "gvd/error.hpp"
#include "gvd/read_soup.hpp"
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

inline const std::string kVtk =
    "# vtk DataFile Version 3.0\na tetrahedron\nASCII\nDATASET POLYDATA\nPOINTS 4 double\n0 0 0 1 1 0\n1 0 1 0 1 1\n"
    "POLYGONS 4 16\n3 0 1 2\n3 0 3 1\n3 0 2 3\n3 1 3 2\n";

inline const std::string kVtp =
    "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" byte_order=\"LittleEndian\"><PolyData>\n"
    "<Piece NumberOfPoints=\"4\" NumberOfPolys=\"4\">\n<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" "
    "format=\"ascii\">0 0 0 1 1 0 1 0 1 0 1 1</DataArray></Points>\n"
    "<Polys><DataArray Name=\"connectivity\" type=\"Int32\" format=\"ascii\">0 1 2 0 3 1 0 2 3 1 3 2</DataArray>"
    "<DataArray Name=\"offsets\" type=\"Int32\" format=\"ascii\">3 6 9 12</DataArray></Polys>\n"
    "</Piece></PolyData></VTKFile>\n";

inline const std::string kVtu =
    "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" byte_order=\"LittleEndian\"><UnstructuredGrid>\n"
    "<Piece NumberOfPoints=\"4\" NumberOfCells=\"4\">\n<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" "
    "format=\"ascii\">0 0 0 1 1 0 1 0 1 0 1 1</DataArray></Points>\n"
    "<Cells><DataArray Name=\"connectivity\" type=\"Int32\" format=\"ascii\">0 1 2 0 3 1 0 2 3 1 3 2</DataArray>"
    "<DataArray Name=\"offsets\" type=\"Int32\" format=\"ascii\">3 6 9 12</DataArray>"
    "<DataArray Name=\"types\" type=\"UInt8\" format=\"ascii\">5 5 7 5</DataArray></Cells>\n"
    "</Piece></UnstructuredGrid></VTKFile>\n";

inline const std::string kMni =
    "P 0.3 0.3 0.4 10 1 4\n 0 0 0\n 1 1 0\n 1 0 1\n 0 1 1\n\n 0 0 1\n 0 0 1\n 0 0 1\n 0 0 1\n\n 4\n 0 1 1 1 1\n\n"
    " 3 6 9 12\n\n 0 1 2 0 3 1 0 2\n 3 1 3 2\n";

inline const std::string kGifti =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!DOCTYPE GIFTI SYSTEM \"gifti.dtd\">\n"
    "<GIFTI Version=\"1.0\" NumberOfDataArrays=\"2\"><MetaData/>\n"
    "<DataArray Intent=\"NIFTI_INTENT_POINTSET\" DataType=\"NIFTI_TYPE_FLOAT32\" ArrayIndexingOrder=\"RowMajorOrder\" "
    "Dimensionality=\"2\" Dim0=\"4\" Dim1=\"3\" Encoding=\"ASCII\" Endian=\"LittleEndian\">"
    "<Data>0 0 0 1 1 0\n1 0 1 0 1 1</Data></DataArray>\n"
    "<DataArray Intent=\"NIFTI_INTENT_TRIANGLE\" DataType=\"NIFTI_TYPE_INT32\" ArrayIndexingOrder=\"RowMajorOrder\" "
    "Dimensionality=\"2\" Dim0=\"4\" Dim1=\"3\" Encoding=\"ASCII\" Endian=\"LittleEndian\">"
    "<Data>0 1 2 0 3 1 0 2 3 1 3 2</Data></DataArray>\n</GIFTI>\n";

/// `text` with the first `from`, which must be there, as `to`.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

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

inline std::string freesurfer_surface() {
  std::string bytes =
      "\xff\xff\xfe"
      "created by hand\n\n" +
      bytes_of(std::int32_t{4}, true) + bytes_of(std::int32_t{4}, true);
  const PolygonSoup soup = parse_soup(kOff, MeshFormat::off, "off");
  for (const Vec3& p : soup.positions) {
    for (const double x : p) bytes += bytes_of(static_cast<float>(x), true);
  }
  for (const std::int32_t v : soup.corners) bytes += bytes_of(v, true);
  return bytes;
}

/// A GLB of a description and a binary chunk.
inline std::string glb_of(std::string json, std::string binary) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  binary.resize((binary.size() + 3) / 4 * 4, '\0');
  const auto words = [](std::initializer_list<std::size_t> values) {
    std::string bytes;
    for (const std::size_t value : values) bytes += bytes_of(static_cast<std::uint32_t>(value));
    return bytes;
  };
  return "glTF" + words({2, 28 + json.size() + binary.size(), json.size(), 0x4E4F534A}) + json +
         words({binary.size(), 0x004E4942}) + binary;
}

/// Positions of the tetrahedron as floats, then its corners as bytes, 16-bit and 32-bit numbers: views 0 to 3.
inline std::string glb_numbers() {
  const PolygonSoup soup = parse_soup(kOff, MeshFormat::off, "off");
  std::string bytes;
  for (const Vec3& p : soup.positions) {
    for (const double x : p) bytes += bytes_of(static_cast<float>(x));
  }
  for (const std::int32_t v : soup.corners) bytes += static_cast<char>(v);
  for (const std::int32_t v : soup.corners) bytes += bytes_of(static_cast<std::uint16_t>(v));
  for (const std::int32_t v : soup.corners) bytes += bytes_of(static_cast<std::uint32_t>(v));
  return bytes;
}

/// The description of one mesh over these numbers. `indices` is 1, 2 or 3.
inline std::string glb_description(int indices, const std::string& nodes = R"([{"mesh":0}])") {
  return R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":)" + nodes +
         R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":)" + std::to_string(indices) + "}]}]," +
         R"("accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},)"
         R"({"bufferView":1,"componentType":5121,"count":12,"type":"SCALAR"},)"
         R"({"bufferView":2,"componentType":5123,"count":12,"type":"SCALAR"},)"
         R"({"bufferView":3,"componentType":5125,"count":12,"type":"SCALAR"}],)"
         R"("bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":12},)"
         R"({"buffer":0,"byteOffset":60,"byteLength":24},{"buffer":0,"byteOffset":84,"byteLength":48}],)"
         R"("buffers":[{"byteLength":132}]})";
}

/// A glTF of a description without buffers, and the address of its one buffer.
inline std::string gltf_of(std::string description, const std::string& uri) {
  const std::string buffers = R"("buffers":[{)";
  return description.insert(description.find(buffers) + buffers.size(), R"("uri":")" + uri + R"(",)");
}

/// The numbers of glb_numbers() in Base64, as Python's base64.b64encode writes them.
inline const std::string kGltfNumbers =
    "data:application/octet-stream;base64,"
    "AAAAAAAAAAAAAAAAAACAPwAAgD8AAAAAAACAPwAAAAAAAIA/AAAAAAAAgD8AAIA/AAECAAMBAAIDAQMCAAABAAIAAAADAAEAAAAC"
    "AAMAAQADAAIAAAAAAAEAAAACAAAAAAAAAAMAAAABAAAAAAAAAAIAAAADAAAAAQAAAAMAAAACAAAA";

inline const std::string kGltf = gltf_of(glb_description(2), kGltfNumbers);

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
