#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <tuple>

#include "gvd/io/label_color.hpp"
#include "support/catch.hpp"

namespace gvd::test_label_color {

int spread(const Rgb& c) { return std::max({c.red, c.green, c.blue}) - std::min({c.red, c.green, c.blue}); }

/// Hue in degrees, by the hexagon.
double hue(const Rgb& c) {
  const double range = spread(c);
  if (c.red >= c.green && c.red >= c.blue) return std::fmod(360 + 60 * (c.green - c.blue) / range, 360.0);
  if (c.green >= c.blue) return 120 + 60 * (c.blue - c.red) / range;
  return 240 + 60 * (c.red - c.green) / range;
}

double hue_difference(int a, int b) {
  const double difference = std::abs(hue(label_color(GeneratorId(a))) - hue(label_color(GeneratorId(b))));
  return std::min(difference, 360 - difference);
}

TEST_CASE("(1) a label's colour is fixed") {
  CHECK(label_color(GeneratorId(0)) == Rgb{242, 92, 92});
  CHECK(label_color(GeneratorId()) == kUnlabelledColor);
  CHECK(spread(kUnlabelledColor) == 0);
}

TEST_CASE("(2) consecutive labels lie a golden angle apart, the first 13 at least 20 degrees") {
  for (int label = 0; label < 1000; ++label) CHECK(hue_difference(label, label + 1) == Approx(137.5).margin(2));
  for (int a = 0; a < 13; ++a) {
    for (int b = 0; b < a; ++b) CHECK(hue_difference(a, b) > 18);  // 20 but for the rounding to bytes
  }
}

TEST_CASE("(3) no label is grey, and hundreds differ") {
  std::set<std::tuple<int, int, int>> colors;
  for (int label = 0; label < 300; ++label) {
    const Rgb color = label_color(GeneratorId(label));
    CHECK(spread(color) > 80);
    colors.insert({color.red, color.green, color.blue});
  }
  CHECK(colors.size() > 290);
  CHECK(spread(label_color(GeneratorId(2147483647))) > 80);
}

TEST_CASE("the colour and the low byte of a label tell 10,000 regions apart") {
  // All that VTK keeps of a label in a PLY: docs/guide/formats.md.
  std::set<std::array<int, 4>> seen;
  for (int i = 0; i < 10000; ++i) {
    const Rgb color = label_color(GeneratorId(i));
    CHECK(seen.insert({color.red, color.green, color.blue, i % 256}).second);
  }
}

}  // namespace gvd::test_label_color
