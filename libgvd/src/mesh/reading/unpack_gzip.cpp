// Unpacks gzip files.
//
// A gzip file is a sequence of members, whose contents are concatenated. It may be padded with zeros to the block size
// of a tape.
// Source: RFC 1952, by zlib.
// Invariant: bytes are counted while they are unpacked, so that a small file can't use up all memory.
#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "gvd/error.hpp"
#include "gvd/text.hpp"
#include "mesh/reading/unpack.hpp"

namespace gvd {
namespace {

/// For inflateInit2: the largest window, and gzip's header.
constexpr int kGzipWindow = 15 + 16;

/// The first bytes of a member.
constexpr std::string_view kGzipMark = "\x1f\x8b";

/// zlib counts the input in 32 bits.
constexpr std::size_t kMostInput = std::numeric_limits<uInt>::max();

class GzipReader {
 public:
  GzipReader(std::string_view bytes, std::string_view name) : bytes_(bytes), name_(name), limit_(bytes.size(), name) {
    if (inflateInit2(&stream_, kGzipWindow) != Z_OK) throw std::bad_alloc();
  }
  ~GzipReader() { inflateEnd(&stream_); }
  GzipReader(const GzipReader&) = delete;
  GzipReader& operator=(const GzipReader&) = delete;

  std::string unpack() {
    do {
      unpack_member();
      inflateReset(&stream_);
    } while (bytes_.starts_with(kGzipMark));
    if (bytes_.find_first_not_of('\0') != bytes_.npos) refuse_rest();
    return std::move(content_);
  }

 private:
  void unpack_member() {
    for (int status = Z_OK; status != Z_STREAM_END;) {
      std::array<Bytef, 1 << 14> block{};
      stream_.next_in = reinterpret_cast<const Bytef*>(bytes_.data());
      stream_.avail_in = static_cast<uInt>(std::min(bytes_.size(), kMostInput));
      stream_.next_out = block.data();
      stream_.avail_out = block.size();
      const uInt given = stream_.avail_in;
      status = inflate(&stream_, Z_NO_FLUSH);
      if (status != Z_OK && status != Z_STREAM_END) refuse(status);
      bytes_.remove_prefix(given - stream_.avail_in);
      const std::size_t made = block.size() - stream_.avail_out;
      limit_.spend(made);
      content_.append(reinterpret_cast<const char*>(block.data()), made);
    }
  }

  [[noreturn]] void refuse(int status) const {
    if (status == Z_MEM_ERROR) throw std::bad_alloc();
    throw Error(ErrorCode::unreadable_input,
                fmt::format("{}: gzip's data {} after {} unpacked bytes; get the file again", name_,
                            status == Z_BUF_ERROR ? "end" : "are damaged", content_.size()));
  }

  [[noreturn]] void refuse_rest() const {
    throw Error(ErrorCode::unreadable_input, fmt::format("{}: {} not gzip; remove them, or get the file again", name_,
                                                         counted(std::ssize(bytes_), "byte after the gzip data is",
                                                                 "bytes after the gzip data are")));
  }

  std::string_view bytes_;  // not read yet
  std::string name_, content_;
  ExpansionLimit limit_;
  z_stream stream_{};
};

}  // namespace

std::string unpack_gzip(std::string_view bytes, std::string_view name) { return GzipReader(bytes, name).unpack(); }

}  // namespace gvd
