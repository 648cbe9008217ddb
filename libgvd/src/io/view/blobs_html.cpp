// The arrays of a page as elements of HTML: deflated, which leaves a third of them, and in Base64.
#include <fmt/format.h>
#include <zlib.h>

#include <new>

#include "io/view/view_blobs.hpp"
#include "io/writers/byte_writer.hpp"

namespace gvd::io {
namespace {

/// The bytes in the format of zlib, which browsers unpack.
std::string deflate(const std::string& bytes) {
  uLongf size = compressBound(uLong(bytes.size()));
  std::string packed(size, '\0');
  const int status = compress(reinterpret_cast<Bytef*>(packed.data()), &size,
                              reinterpret_cast<const Bytef*>(bytes.data()), uLong(bytes.size()));
  if (status != Z_OK) throw std::bad_alloc();  // the only way to fail into a buffer of that size
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
