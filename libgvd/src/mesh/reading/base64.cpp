// Decodes Base64 in XML and in glTF's addresses.
//
// Source: RFC 4648.
// Invariant: memory is never allocated for a size in the file that the file's bytes could not fill.
#include <algorithm>
#include <utility>

#include "mesh/reading/array_bytes.hpp"

namespace gvd {
namespace {

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

/// Decodes the next four digits and appends three bytes, or fewer if the digits end in padding. Returns false at the
/// end and for anything but Base64.
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

}  // namespace gvd
