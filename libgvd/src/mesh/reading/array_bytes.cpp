// Decodes arrays of numbers inside XML, for VTK's files and GIFTI, from zlib's format and from text.
//
// Source: zlib, Technical Details, for the limit of deflate.
// Invariant: memory is never allocated for a size in the file that the file's bytes could not fill.
#include "mesh/reading/array_bytes.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <new>

#include "gvd/error.hpp"
#include "gvd/text.hpp"
#include "mesh/reading/readers.hpp"

namespace gvd {
namespace {

/// A byte of deflate's output needs at least 1 / 1032 of its input.
constexpr std::uint64_t kMostDeflated = 1032;

}  // namespace

bool append_inflated(std::string& content, std::string_view packed, std::uint64_t size, ExpansionLimit& limit,
                     std::uint64_t* unused) {
  if (size > kMostDeflated * packed.size()) return false;
  limit.spend(size + packed.size());
  const std::size_t begin = content.size();
  if (size > content.max_size() - begin) throw std::bad_alloc();
  content.resize(begin + size);
  uLongf made = size;
  uLong taken = packed.size();
  const int status = uncompress2(reinterpret_cast<Bytef*>(content.data() + begin), &made,
                                 reinterpret_cast<const Bytef*>(packed.data()), &taken);
  if (status == Z_MEM_ERROR) throw std::bad_alloc();
  if (unused != nullptr) *unused = packed.size() - taken;
  return status == Z_OK && made == size;
}

std::optional<std::uint64_t> inflated_size(std::string_view packed, std::uint64_t most) {
  z_stream stream{};
  if (inflateInit(&stream) != Z_OK) throw std::bad_alloc();
  std::string block(std::size_t{1} << 14, '\0');
  std::uint64_t made = 0;
  int status = Z_OK;
  while (status == Z_OK && made < most) {
    if (stream.avail_in == 0) {
      const std::string_view next = packed.substr(0, block.size());
      stream.next_in = reinterpret_cast<const Bytef*>(next.data());
      stream.avail_in = static_cast<uInt>(next.size());
      packed.remove_prefix(next.size());
    }
    stream.next_out = reinterpret_cast<Bytef*>(block.data());
    stream.avail_out = static_cast<uInt>(block.size());
    status = inflate(&stream, Z_NO_FLUSH);
    made += block.size() - stream.avail_out;
  }
  inflateEnd(&stream);
  if (status == Z_MEM_ERROR) throw std::bad_alloc();
  if (status != Z_OK && status != Z_STREAM_END) return std::nullopt;
  return std::min(made, most);
}

std::optional<std::uint64_t> parse_count(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return parse_number<std::uint64_t>(text);
}

std::vector<double> parse_array_text(std::string_view text, std::string_view what, std::string_view name) {
  constexpr std::string_view kBlank = " \t\r\n\v\f";
  std::vector<double> numbers;
  for (std::size_t at = text.find_first_not_of(kBlank); at < text.size(); at = text.find_first_not_of(kBlank, at)) {
    const std::string_view token = text.substr(at, text.find_first_of(kBlank, at) - at);
    const auto number = parse_double(token);
    if (!number) {
      throw Error(ErrorCode::unreadable_input,
                  fmt::format("{}: {} is not a number in an array of {}", name, quoted(token), what));
    }
    numbers.push_back(*number);
    at += token.size();
  }
  return numbers;
}

}  // namespace gvd
