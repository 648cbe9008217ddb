#include <sstream>
#include <stdexcept>
#include <string>

#include "gvd/io/read_to_end.hpp"
#include "support/catch.hpp"

namespace gvd::test_read_to_end {

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

}  // namespace gvd::test_read_to_end
