#include <nlohmann/json.hpp>

#include "io/view/view_blobs.hpp"
#include "io/writers/base64.hpp"
#include "support/catch.hpp"

namespace gvd::test_view_blobs {

using namespace test;

TEST_CASE("arrays are little-endian, narrow, and stored once") {
  io::ViewBlobs blobs;
  CHECK(blobs.add_integers({1, 255}) == nlohmann::json({{"blob", 0}, {"type", "u8"}, {"count", 2}}));
  CHECK(blobs.add_integers({1, 256}) == nlohmann::json({{"blob", 1}, {"type", "u16"}, {"count", 2}}));
  CHECK(blobs.add_integers({65536}) == nlohmann::json({{"blob", 2}, {"type", "u32"}, {"count", 1}}));
  CHECK(blobs.add_floats({1.0f}) == nlohmann::json({{"blob", 3}, {"type", "f32"}, {"count", 1}}));
  CHECK(blobs.add_integers({1, 256})["blob"] == 1);
  CHECK(blobs.html().find("id=\"blob-1\">" + io::encode_base64(std::string("\1\0\0\1", 4)) + "</script>") !=
        std::string::npos);
  CHECK(blobs.html().find("blob-4") == std::string::npos);
}

TEST_CASE("an empty array is an array, and arrays of other types with equal bytes are stored once") {
  io::ViewBlobs blobs;
  CHECK(blobs.add_integers({}) == nlohmann::json({{"blob", 0}, {"type", "u8"}, {"count", 0}}));
  CHECK(blobs.add_floats({}) == nlohmann::json({{"blob", 0}, {"type", "f32"}, {"count", 0}}));
  CHECK(blobs.add_integers({0, 0, 0, 0})["blob"] == 1);
  CHECK(blobs.add_floats({0.0f})["blob"] == 1);
  CHECK(blobs.html() ==
        "<script type=\"application/octet-stream\" id=\"blob-0\"></script>\n"
        "<script type=\"application/octet-stream\" id=\"blob-1\">AAAAAA==</script>\n");
}

}  // namespace gvd::test_view_blobs
