#include "io/writers/base64.hpp"
#include "support/catch.hpp"

namespace gvd::test_base64 {

struct Text {
  void text(std::string_view digits) { all.append(digits); }
  std::string all;
};

TEST_CASE("base64 is that of RFC 4648") {
  CHECK(io::encode_base64("") == "");
  CHECK(io::encode_base64("f") == "Zg==");
  CHECK(io::encode_base64("fo") == "Zm8=");
  CHECK(io::encode_base64("foo") == "Zm9v");
  CHECK(io::encode_base64("foob") == "Zm9vYg==");
  CHECK(io::encode_base64("fooba") == "Zm9vYmE=");
  CHECK(io::encode_base64("foobar") == "Zm9vYmFy");
  CHECK(io::encode_base64("\xFF\xFE\xFD") == "//79");
}

TEST_CASE("numbers are encoded as the little-endian bytes that follow each other") {
  Text out;
  io::Base64Writer writer(out);
  writer.binary(std::uint32_t{0x44434241});  // "ABCD"
  writer.binary(std::uint16_t{0x4645});      // "EF"
  writer.byte('G');
  CHECK(out.all == io::encode_base64("ABCDEF"));
  writer.finish();
  CHECK(out.all == io::encode_base64("ABCDEFG"));
}

TEST_CASE("no bytes have no digits") {
  Text out;
  io::Base64Writer writer(out);
  writer.finish();
  CHECK(out.all.empty());
}

}  // namespace gvd::test_base64
