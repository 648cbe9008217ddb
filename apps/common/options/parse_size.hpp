#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace gvd::app {

/// "500M" as bytes: a number above 0, maybe with a fraction, and K, M, G or T for 1024 to the first to fourth, in
/// capital or small letters; nothing for bytes. "B" or "iB" may follow. Nothing where `text` is no size, or is too
/// large.
std::optional<std::int64_t> parse_size(std::string_view text);

}  // namespace gvd::app
