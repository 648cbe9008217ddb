#include <sstream>
#include <stdexcept>
#include <string>

#include "gvd/text.hpp"
#include "support/catch.hpp"

namespace gvd::test_text {

TEST_CASE("texts from files are printable and short in messages") {
  CHECK(printable("abc") == "abc");
  CHECK(printable("a\tb\xff") == "a?b?");
  CHECK(printable("abcdef", 3) == "abc...");
  CHECK(printable("") == "");
}

TEST_CASE("a quotation is short and printable") {
  CHECK(gvd::quoted("abc") == "'abc'");
  CHECK(gvd::quoted("a\n\x01\xff") == "'a" + std::string(3, '?') + "'");
  CHECK(gvd::quoted(std::string(100, 'x')) == "'" + std::string(kLongestQuote, 'x') + "...'");
}

TEST_CASE("counted: singular for one only") {
  CHECK(counted(0, "face", "faces") == "0 faces");
  CHECK(counted(1, "face", "faces") == "1 face");
  CHECK(counted(2'000'000'000'000, "face", "faces") == "2000000000000 faces");
}

/// Gives some bytes, and then fails.
class FailingBuffer : public std::stringbuf {
 public:
  FailingBuffer() : std::stringbuf("some") {}

 private:
  int_type underflow() override { throw std::runtime_error("the device is gone"); }
};

TEST_CASE("a stream is read to its end, whatever its length and its bytes") {
  for (const std::size_t length : {0, 1, 16383, 16384, 16385, 100000}) {
    std::string bytes(length, '\0');
    for (std::size_t i = 0; i < length; ++i) bytes[i] = static_cast<char>(i % 251);
    std::istringstream in(bytes);
    CHECK(read_to_end(in) == bytes);
    CHECK_FALSE(in.bad());
  }
}

TEST_CASE("a stream that fails is bad afterwards") {
  FailingBuffer buffer;
  std::istream in(&buffer);
  read_to_end(in);
  CHECK(in.bad());
}

}  // namespace gvd::test_text
