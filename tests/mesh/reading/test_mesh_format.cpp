#include "gvd/mesh_format.hpp"
#include "mesh/reading/read_off.hpp"
#include "mesh/reading/read_stl.hpp"
#include "mesh/reading/soup_files.hpp"
#include "support/catch.hpp"

namespace gvd::test_mesh_format {

TEST_CASE("mesh format: names and extensions, upper or lower case") {
  for (const MeshFormat format : {MeshFormat::obj, MeshFormat::ply, MeshFormat::off, MeshFormat::stl}) {
    CHECK(format_from_extension(name_of(format)) == format);
    CHECK(format_from_extension("a.b/model." + std::string(name_of(format))) == format);
  }
  CHECK(format_from_extension("MODEL.OBJ") == MeshFormat::obj);
  CHECK_FALSE(format_from_extension("model.glb"));
  CHECK_FALSE(format_from_extension(""));
}

TEST_CASE("mesh format: the content decides, and the extension only where the content says nothing") {
  CHECK(detect_format(test::kObj, "a.stl") == MeshFormat::obj);
  CHECK(detect_format(test::kPly, "a.obj") == MeshFormat::ply);
  CHECK(detect_format(test::kOff, "a") == MeshFormat::off);
  CHECK(detect_format(test::kStl, "a.off") == MeshFormat::stl);
  CHECK(detect_format(test::binary_stl(), "a.off") == MeshFormat::stl);
  CHECK(detect_format("4 4 6\n", "a.off") == MeshFormat::off);
  for (const std::string before : {"\xEF\xBB\xBF", " ", "\t"}) {
    CHECK(detect_format(before + test::kPly, "a.obj") == MeshFormat::ply);
  }
  CHECK_FALSE(detect_format("plywood\n", "a"));
  CHECK_FALSE(detect_format("ply", "a"));
  CHECK_FALSE(detect_format("hello\n", "a.txt"));
  CHECK_FALSE(detect_format("hello\n", "off"));
}

TEST_CASE("mesh format: OFF keywords, and the length of a binary STL") {
  for (const char* word : {"OFF", "COFF", "NOFF", "STCNOFF", "4OFF", "nOFF"}) CHECK(is_off_keyword(word));
  for (const char* word : {"", "off", "OFFX", "XOFF"}) CHECK_FALSE(is_off_keyword(word));
  CHECK(is_binary_stl(test::binary_stl()));
  CHECK_FALSE(is_binary_stl(test::binary_stl() + "x"));
  CHECK_FALSE(is_binary_stl(std::string(84, '\0')));
  CHECK_FALSE(is_binary_stl(""));
}

}  // namespace gvd::test_mesh_format
