#include "io/writers/base64.hpp"

#include <utility>

namespace gvd::io {
namespace {

struct StringSink {
  void text(std::string_view digits) { string.append(digits); }
  std::string string;
};

}  // namespace

std::string encode_base64(std::string_view bytes) {
  StringSink sink;
  sink.string.reserve((bytes.size() + 2) / 3 * 4);
  Base64Writer writer(sink);
  for (const char byte : bytes) writer.byte(static_cast<unsigned char>(byte));
  writer.finish();
  return std::move(sink.string);
}

}  // namespace gvd::io
