// Buffered text and bytes, Base64, and pieces of JSON.
#include <clocale>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "io/writers/byte_writer.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

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
  std::string out;
  io::Base64Writer writer(out);
  writer.binary(std::uint32_t{0x44434241});  // "ABCD"
  writer.binary(std::uint16_t{0x4645});      // "EF"
  writer.byte('G');
  CHECK(out == io::encode_base64("ABCDEF"));
  writer.finish();
  CHECK(out == io::encode_base64("ABCDEFG"));
}

TEST_CASE("no bytes have no digits") {
  std::string out;
  io::Base64Writer writer(out);
  writer.finish();
  CHECK(out.empty());
}

/// What `print` prints.
template <class Print>
std::string printed(Print print) {
  std::ostringstream stream;
  io::ByteWriter out(stream);
  print(out);
  out.finish();
  return stream.str();
}

std::string lines_of(const std::vector<int>& items) {
  return printed([&](io::ByteWriter& out) { io::print_lines(out, items, [&](int i) { out.print("{}", i); }); });
}

std::string array_of(const std::vector<int>& items) {
  return printed([&](io::ByteWriter& out) { io::print_array(out, items, [&](int i) { out.print("{}", i); }); });
}

TEST_CASE("a number has its shortest digits, infinity and NaN are null") {
  using Double = std::numeric_limits<double>;
  CHECK(io::json_number(0.1) == "0.1");
  CHECK(io::json_number(3) == "3");
  CHECK(io::json_number(1e-7) == "1e-07");
  for (const double value : {Double::infinity(), -Double::infinity(), Double::quiet_NaN()}) {
    CHECK(io::json_number(value) == "null");
  }
  for (const double value : {1.0 / 3, Double::max(), Double::denorm_min(), -0.0}) {
    CHECK(nlohmann::json::parse(io::json_number(value)).get<double>() == value);
  }
}

TEST_CASE("a surface point has its face, its coordinates and its position") {
  const Mesh mesh = make_grid(2, 2);
  const SurfacePoint point = make_surface_point(FaceId(3), {0.25, 0.25, 0.5});
  const auto json =
      nlohmann::ordered_json::parse(printed([&](io::ByteWriter& out) { io::print_point(out, mesh, point); }));
  const Vec3 p = position(mesh, point);
  CHECK(json.dump() ==
        nlohmann::ordered_json({{"face", 3}, {"bary", {0.25, 0.25, 0.5}}, {"position", {p.x(), p.y(), 0}}}).dump());
}

TEST_CASE("an array is printed on one line, or with a line for each item") {
  CHECK(lines_of({}) == "[]");
  CHECK(lines_of({1}) == "[\n  1\n]");
  CHECK(lines_of({1, 2}) == "[\n  1,\n  2\n]");
  CHECK(array_of({}) == "[]");
  CHECK(array_of({1}) == "[1]");
  CHECK(array_of({1, 2}) == "[1,2]");
}

}  // namespace gvd::test_byte_writer
