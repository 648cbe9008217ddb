#include <clocale>
#include <cstdint>
#include <sstream>

#include "io/writers/byte_writer.hpp"
#include "support/catch.hpp"

namespace gvd::test_byte_writer {

using namespace test;

/// Counts the writes that reach a stream.
class CountingBuffer : public std::stringbuf {
 public:
  int writes = 0;

 protected:
  std::streamsize xsputn(const char* bytes, std::streamsize count) override {
    ++writes;
    return std::stringbuf::xsputn(bytes, count);
  }
};

TEST_CASE("text, formatted numbers and little-endian bytes follow each other") {
  std::ostringstream stream;
  io::ByteWriter out(stream);
  out.text("a,");
  out.print("{} {:.2f};", 7, 0.125);
  out.binary(std::uint32_t{0x04030201});
  out.binary(std::uint8_t{5});
  out.binary(1.0f);
  out.finish();
  CHECK(stream.str() == std::string("a,7 0.12;\1\2\3\4\5\0\0\x80\x3f", 18));
}

TEST_CASE("a double is printed with the digits that bring it back, in any locale") {
  std::setlocale(LC_ALL, "de_DE.UTF-8");
  for (const double value : {0.1, 1.0 / 3, 1e300, 5e-324, -0.0}) {
    std::ostringstream stream;
    io::ByteWriter out(stream);
    out.print("{}", value);
    out.finish();
    CHECK(stream.str().find(',') == std::string::npos);
    std::istringstream back(stream.str());
    std::string text;
    back >> text;
    CHECK(fmt::format("{}", value) == text);
  }
  std::setlocale(LC_ALL, "C");
}

TEST_CASE("many small pieces reach the stream in few writes") {
  CountingBuffer buffer;
  std::ostream stream(&buffer);
  io::ByteWriter out(stream);
  for (int i = 0; i < 1000000; ++i) out.binary(std::uint8_t{7});
  out.finish();
  CHECK(buffer.str().size() == 1000000);
  CHECK(buffer.writes < 20);
}

TEST_CASE("a stream that fails is an error, at the latest at the end") {
  std::ostringstream stream;
  stream.setstate(std::ios::badbit);
  io::ByteWriter out(stream);
  out.text("small");
  try {
    out.finish();
    FAIL("no error");
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::unwritable_output);
  }
  CHECK_THROWS_AS(out.text(std::string(1 << 20, 'x')), Error);
}

}  // namespace gvd::test_byte_writer
