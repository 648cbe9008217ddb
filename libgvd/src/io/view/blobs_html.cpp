// Writes the arrays of a page as HTML elements: deflated, to about a third of their size, and in Base64.
#include <fmt/format.h>
#include <zlib.h>

#include <new>

#include "io/view/view_blobs.hpp"
#include "io/writers/byte_writer.hpp"

namespace gvd::io {
namespace {

/// Compresses bytes in zlib's format, which browsers can unpack.
std::string deflate(const std::string& bytes) {
  uLongf size = compressBound(uLong(bytes.size()));
  std::string packed(size, '\0');
  const int status = compress(reinterpret_cast<Bytef*>(packed.data()), &size,
                              reinterpret_cast<const Bytef*>(bytes.data()), uLong(bytes.size()));
  if (status != Z_OK) throw std::bad_alloc();  // with a buffer of this size, compress fails only for lack of memory
  packed.resize(size);
  return packed;
}

}  // namespace

std::string ViewBlobs::html() const {
  std::string html;
  for (std::size_t i = 0; i < blobs_.size(); ++i) {
    html += fmt::format("<script type=\"application/octet-stream\" id=\"blob-{}\">", i);
    html += encode_base64(deflate(*blobs_[i]));
    html += "</script>\n";
  }
  return html;
}

}  // namespace gvd::io
