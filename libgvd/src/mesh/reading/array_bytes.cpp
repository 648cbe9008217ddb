// Arrays of numbers inside XML, for VTK's files and GIFTI: Base64, zlib and text.
//
// Source: RFC 4648 for Base64; zlib, Technical Details, for the limit of deflate.
// Invariant: no size that a file gives takes memory that its bytes could not fill.
#include "mesh/reading/array_bytes.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <new>
#include <utility>

#include "gvd/error.hpp"
#include "gvd/text.hpp"
#include "mesh/reading/readers.hpp"

namespace gvd {
namespace {

/// A byte of deflate's output needs at least 1 / 1032 of its input.
constexpr std::uint64_t kMostDeflated = 1032;

/// The value of a Base64 digit, or -1.
int base64_value(char digit) {
  if (digit >= 'A' && digit <= 'Z') return digit - 'A';
  if (digit >= 'a' && digit <= 'z') return digit - 'a' + 26;
  if (digit >= '0' && digit <= '9') return digit - '0' + 52;
  if (digit == '+') return 62;
  return digit == '/' ? 63 : -1;
}

}  // namespace

std::string ArrayBytes::take(std::uint64_t count) {
  if (!is_base64_) {
    const std::string taken(data_.substr(0, count));
    data_.remove_prefix(taken.size());
    return taken;
  }
  std::string taken = std::move(pending_);
  taken.reserve(std::min(count, most()) + 2);
  while (taken.size() < count && decode_four(taken)) continue;
  pending_ = taken.size() > count ? taken.substr(count) : "";
  taken.resize(std::min<std::uint64_t>(count, taken.size()));
  return taken;
}

/// Appends what the next four digits stand for: three bytes, or fewer where padding follows.
bool ArrayBytes::decode_four(std::string& bytes) {
  std::uint32_t bits = 0;
  int digits = 0, padding = 0;
  while (digits + padding < 4 && !data_.empty()) {
    const char c = data_.front();
    data_.remove_prefix(1);
    if (c == ' ' || (c >= '\t' && c <= '\r')) continue;
    const int value = c == '=' ? 0 : base64_value(c);
    if (value < 0 || (c != '=' && padding > 0)) return false;
    (c == '=' ? padding : digits)++;
    bits = bits << 6 | std::uint32_t(value);
  }
  if (digits + padding < 4 || padding > 2) return false;
  for (int i = 0; i < 3 - padding; ++i) bytes += static_cast<char>(bits >> (16 - 8 * i));
  return true;
}

bool append_inflated(std::string& content, std::string_view packed, std::uint64_t size, ExpansionLimit& limit) {
  if (size > kMostDeflated * packed.size()) return false;
  limit.spend(size + packed.size());
  const std::size_t begin = content.size();
  if (size > content.max_size() - begin) throw std::bad_alloc();
  content.resize(begin + size);
  uLongf made = size;
  const int status = uncompress(reinterpret_cast<Bytef*>(content.data() + begin), &made,
                                reinterpret_cast<const Bytef*>(packed.data()), packed.size());
  if (status == Z_MEM_ERROR) throw std::bad_alloc();
  return status == Z_OK && made == size;
}

std::vector<double> parse_array_text(std::string_view text, std::string_view what, std::string_view name) {
  constexpr std::string_view kBlank = " \t\r\n\v\f";
  std::vector<double> numbers;
  for (std::size_t at = text.find_first_not_of(kBlank); at < text.size(); at = text.find_first_not_of(kBlank, at)) {
    const std::string_view token = text.substr(at, text.find_first_of(kBlank, at) - at);
    const auto number = parse_double(token);
    if (!number) {
      throw Error(ErrorCode::unreadable_input,
                  fmt::format("{}: {} is no number in an array of {}", name, quoted(token), what));
    }
    numbers.push_back(*number);
    at += token.size();
  }
  return numbers;
}

}  // namespace gvd
