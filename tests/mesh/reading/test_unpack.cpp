// gzip around each format, its limits, and the names of contents that are no mesh.
#include <zlib.h>

#include <vector>

#include "gvd/mesh_property.hpp"
#include "mesh/reading/soup_files.hpp"
#include "mesh/reading/unpack.hpp"
#include "support/catch.hpp"

namespace gvd::test_unpack {

using namespace test;

// One member of a gzip file.
std::string pack(const std::string& bytes) {
  z_stream stream{};
  REQUIRE(deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, 15 + 16, 9, Z_DEFAULT_STRATEGY) == Z_OK);
  std::string packed(deflateBound(&stream, bytes.size()), '\0');
  stream.next_in = reinterpret_cast<const Bytef*>(bytes.data());
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  REQUIRE(deflate(&stream, Z_FINISH) == Z_STREAM_END);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

TEST_CASE("gzip: every format is read through it, in one member or in several, with zeros behind") {
  for (const auto& [format, bytes] : {std::pair(MeshFormat::obj, kObj),
                                      {MeshFormat::off, kOff},
                                      {MeshFormat::ply, kPly},
                                      {MeshFormat::ply, binary_ply(true)},
                                      {MeshFormat::stl, kStl},
                                      {MeshFormat::stl, binary_stl()},
                                      {MeshFormat::vtp, kVtp},
                                      {MeshFormat::vtk, kVtk},
                                      {MeshFormat::glb, glb_of(glb_description(1), glb_numbers())}}) {
    INFO(name_in(input_format_names(), format));
    require_tetrahedron(parse_soup(pack(bytes), format, "file"));
    const std::string parts = pack(bytes.substr(0, 50)) + pack("") + pack(bytes.substr(50)) + std::string(100, '\0');
    require_tetrahedron(parse_soup(parts, format, "file"));
    CHECK(unpack_gzip(parts, "file") == bytes);
  }
}

TEST_CASE("gzip: properties are read through it") {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty float "
      "w\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0 7\n1 0 0 8\n0 1 0 9\n3 0 1 2\n";
  const auto found = parse_mesh_properties(pack(ply), MeshFormat::ply, "file");
  REQUIRE(found.size() == 1);
  CHECK(found[0].values == std::vector<double>{7, 8, 9});
}

TEST_CASE("gzip: a damaged, cut or endless file is refused in one line") {
  const std::string packed = pack(kOff);
  for (std::size_t size = 3; size < packed.size(); ++size) {
    INFO(size);
    require_refused(packed.substr(0, size), MeshFormat::off, "gzip's data end after");
  }
  std::string wrong = packed;
  wrong[packed.size() - 6] ^= 1;  // of the checksum
  require_refused(wrong, MeshFormat::off, "gzip's data are damaged after");
  require_refused(packed + "more", MeshFormat::off, "4 bytes after the gzip data are not gzip");
  require_refused(packed + '\0' + packed, MeshFormat::off, "after the gzip data are not gzip");
  require_refused(pack(packed), MeshFormat::off, "compressed by gzip; unpack it first");
  require_refused(pack(""), MeshFormat::off, "the file is empty");
  const std::string bomb = pack(std::string(8 << 20, ' '));
  require_refused(bomb, MeshFormat::off, "expands to more than 200 times its size");
  // The limit itself: what it allows passes, and one byte more does not.
  ExpansionLimit limit(10, "file");
  limit.spend(kMostExpansion * 10);
  limit.spend(kFreeExpansion);
  CHECK_THROWS_AS(limit.spend(1), Error);
}

// How an object of MNI shines, and the number of its points.
std::string binary_surface(bool big_endian, float shine = 10) {
  std::string bytes;
  for (const float number : {0.3F, 0.3F, 0.4F, shine, 1.F}) bytes += bytes_of(number, big_endian);
  return bytes + bytes_of(std::int32_t{4}, big_endian);
}

// Text as UTF-16 with a byte order mark.
std::string utf16(std::string_view text, bool big_endian) {
  std::string bytes = big_endian ? "\xfe\xff" : "\xff\xfe";
  for (const char c : text) bytes += big_endian ? std::string{'\0', c} : std::string{c, '\0'};
  return bytes;
}

TEST_CASE("utf-16: every text format is read and told apart in both orders of bytes, also through gzip") {
  for (const auto& [format, bytes] : {std::pair(MeshFormat::obj, kObj),
                                      {MeshFormat::off, kOff},
                                      {MeshFormat::ply, kPly},
                                      {MeshFormat::stl, kStl},
                                      {MeshFormat::vtp, kVtp},
                                      {MeshFormat::vtu, kVtu},
                                      {MeshFormat::vtk, kVtk},
                                      {MeshFormat::mni, kMni},
                                      {MeshFormat::gii, replaced(kGifti, "UTF-8", "UTF-16")}}) {
    for (const bool big : {false, true}) {
      INFO(name_in(input_format_names(), format) << big);
      const std::string wide = utf16(bytes, big);
      CHECK(detect_format(wide, "a.txt") == format);
      require_tetrahedron(parse_soup(wide, format, "file"));
      require_tetrahedron(parse_soup(pack(wide), format, "file"));
    }
  }
  require_refused(utf16("<html>", false), MeshFormat::obj, "an HTML page");
}

TEST_CASE("utf-16: characters of every length become UTF-8, and what is none U+FFFD") {
  CHECK(to_utf8(std::string_view("\xff\xfe"
                                 "A\0\xe9\0\xac\x20\x3d\xd8\x00\xde",
                                 12)) == "A\xc3\xa9\xe2\x82\xac\xf0\x9f\x98\x80");
  CHECK(to_utf8(std::string_view("\xfe\xff\xd8\x3d\x00"
                                 "A\x00",
                                 7)) ==
        "\xef\xbf\xbd"
        "A"
        "\xef\xbf\xbd");
  CHECK(to_utf8("\xff\xfe").empty());
  std::string stl = binary_stl();
  stl.replace(0, 2, "\xff\xfe");
  CHECK_FALSE(is_utf16(stl));
  require_tetrahedron(parse_soup(stl, MeshFormat::stl, "file"));
  CHECK_FALSE(is_utf16(freesurfer_surface()));
}

TEST_CASE("content that is no mesh is named, whatever the extension says") {
  const std::vector<std::pair<std::string, std::string>> contents{
      {"version https://git-lfs.github.com/spec/v1\noid sha256:0\n", "the file is a Git LFS pointer"},
      {" \n<!DOCTYPE HTML>\n<p>404", "an HTML page"},
      {"<html lang=en>", "an HTML page"},
      {"\xEF\xBB\xBF<?xml version=\"1.0\"?><!-- c --><COLLADA>", "XML of the kind 'COLLADA'"},
      {"<?xml version=\"1.0\"?>\n<!DOCTYPE svg SYSTEM \"g.dtd\">\n<svg>", "XML of the kind 'svg'"},
      {"<", "XML of the kind ''"},
      {"\x89PNG\r\n", "a PNG image"},
      {"PK\x03\x04", "compressed by zip"},
      {"PK\x03\x04 .... [Content_Types].xml .... 3D/3Dmodel.model", "a 3MF model; export the mesh as STL, PLY or OBJ"},
      {"{\"generators\":[]}", "JSON but not glTF"},
      {std::string("v\0 \0"
                   "0\0 \0"
                   "0\0",
                   10),
       "text in UTF-16 without a byte order mark; save it as UTF-8"},
      {std::string("\0v\0 \0"
                   "0\0 ",
                   8),
       "text in UTF-16 without a byte order mark"},
      {std::string("\xff\xfe\0\0v\0\0\0", 8), "text in UTF-32"},
      {"p" + binary_surface(false), "a binary object of MNI; write it as text, or as PLY"},
      {"p" + binary_surface(true), "a binary object of MNI"},
      {"p" + binary_surface(false, 12345), "a binary object of MNI"},
      {"p" + binary_surface(true, -1), "a binary object of MNI"},
      {"$MeshFormat\n4.1 0 8\n", "a Gmsh mesh"}};
  for (const auto& [bytes, part] : contents) {
    for (const MeshFormat format : {MeshFormat::obj, MeshFormat::ply, MeshFormat::stl, MeshFormat::glb}) {
      require_refused(bytes, format, part);
    }
  }
  for (const std::string& bytes : {kObj, kOff, kPly, kStl, kVtp, kVtu, kVtk, kMni, kGifti, kGltf, std::string("hello"),
                                   std::string("p 1"), std::string()}) {
    CHECK(describe_content(bytes).empty());
  }
  std::string stl = binary_stl();
  stl.replace(0, 5, "%PDF-");
  require_tetrahedron(parse_soup(stl, MeshFormat::stl, "file"));
}

}  // namespace gvd::test_unpack
