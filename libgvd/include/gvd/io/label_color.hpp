#pragma once

#include <cstdint>

#include "gvd/ids.hpp"

namespace gvd {

/// A colour in sRGB, 0 to 255.
struct Rgb {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
  bool operator==(const Rgb&) const = default;
};

/// The grey of faces and vertices that no generator reaches.
inline constexpr Rgb kUnlabelledColor{160, 160, 160};

/// The colour of a generator's region, the same in every file; kUnlabelledColor for an invalid id. Pages
/// have few colours instead, chosen so that neighbours differ (gvd/io/view.hpp).
///
/// Properties: (1) it depends on the id alone and is the same on every machine; (2) the hues of consecutive ids differ
/// by the golden angle (137.5 degrees), those of any two of the first 13 by at least 20; (3) no label is grey.
/// Cost: O(1), no allocation.
Rgb label_color(GeneratorId generator);

}  // namespace gvd
