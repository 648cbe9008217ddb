#pragma once

#include <cstdint>
#include <vector>

namespace gvd {

/// A colour in sRGB, 0 to 255.
struct Rgb {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
  bool operator==(const Rgb&) const = default;
};

/// The grey of faces and vertices that no generator reaches.
inline constexpr Rgb kUnlabelledColor{0x9c, 0x9a, 0x97};

struct LabelledMesh;

/// Chooses the colour of each label up to the largest one. Every file of the mesh, and its page, use these colours.
///
/// Properties: (1) labels that meet along an edge differ by at least 14 in CIEDE2000, also for the colour-blind, on
/// surfaces with up to three handles; (2) so do labels with a common bisector, unless (1) forbids it; (3) colours are
/// few: labels that do not meet may share one; (4) they depend on the labels alone and are the same on every machine.
/// Cost: O(n log n) time, O(n + largest label) memory.
std::vector<Rgb> region_colors(const LabelledMesh& mesh);

}  // namespace gvd
