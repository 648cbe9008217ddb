#include "gvd/io/label_color.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace gvd {
namespace {

/// The golden angle as a fraction of the circle: (3 - sqrt 5) / 2. Its multiples are spread evenly.
constexpr double kGoldenTurn = 0.38196601125010515;

struct Tone {
  double saturation;
  double value;
};
/// Used in turn, so that labels with similar hues differ in tone.
constexpr std::array<Tone, 3> kTones{{{0.62, 0.95}, {0.85, 0.78}, {0.45, 0.88}}};

std::uint8_t to_byte(double channel) { return static_cast<std::uint8_t>(std::lround(255 * channel)); }

/// One channel of the colour (hue, saturation, value); `offset` is 5, 3, 1 for red, green, blue.
double channel(double offset, double hue, const Tone& tone) {
  const double k = std::fmod(offset + 6 * hue, 6.0);
  return tone.value * (1 - tone.saturation * std::clamp(std::min(k, 4 - k), 0.0, 1.0));
}

}  // namespace

Rgb label_color(GeneratorId generator) {
  if (!generator.valid()) return kUnlabelledColor;
  const double turns = kGoldenTurn * generator.value();
  const double hue = turns - std::floor(turns);
  const Tone& tone = kTones[generator.index() % kTones.size()];
  return {to_byte(channel(5, hue, tone)), to_byte(channel(3, hue, tone)), to_byte(channel(1, hue, tone))};
}

}  // namespace gvd
