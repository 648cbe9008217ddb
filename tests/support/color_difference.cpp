#include "support/color_difference.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gvd::test {
namespace {

constexpr double kPi = 3.14159265358979323846;

double degrees(double radians) { return radians * 180 / kPi; }
double radians(double degrees) { return degrees * kPi / 180; }

double hue(double a, double b) {
  if (a == 0 && b == 0) return 0;
  const double h = degrees(std::atan2(b, a));
  return h < 0 ? h + 360 : h;
}

/// Mean of two hues; the sum where one of the colours has none.
double mean_hue(double h1, double h2, bool grey) {
  if (grey) return h1 + h2;
  if (std::abs(h1 - h2) <= 180) return (h1 + h2) / 2;
  return h1 + h2 < 360 ? (h1 + h2 + 360) / 2 : (h1 + h2 - 360) / 2;
}

double hue_step(double h1, double h2, bool grey) {
  if (grey) return 0;
  const double step = h2 - h1;
  return step > 180 ? step - 360 : step < -180 ? step + 360 : step;
}

/// sqrt(c^7 / (c^7 + 25^7)).
double chroma_weight(double c) { return std::sqrt(std::pow(c, 7) / (std::pow(c, 7) + std::pow(25.0, 7))); }

double to_linear(int byte) {
  const double s = byte / 255.0;
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

Lab to_lab(const std::array<double, 3>& linear) {
  constexpr double kXyz[3][3] = {
      {0.4124564, 0.3575761, 0.1804375}, {0.2126729, 0.7151522, 0.0721750}, {0.0193339, 0.1191920, 0.9503041}};
  double f[3];
  for (int i = 0; i < 3; ++i) {
    double value = 0, white = 0;
    for (int k = 0; k < 3; ++k) {
      value += kXyz[i][k] * linear[std::size_t(k)];
      white += kXyz[i][k];
    }
    const double t = value / white;
    f[i] = t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116;
  }
  return {116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
}

}  // namespace

double ciede2000(const Lab& one, const Lab& two) {
  const double mean_chroma = (std::hypot(one[1], one[2]) + std::hypot(two[1], two[2])) / 2;
  const double g = 0.5 * (1 - chroma_weight(mean_chroma));
  const double a1 = (1 + g) * one[1], a2 = (1 + g) * two[1];
  const double c1 = std::hypot(a1, one[2]), c2 = std::hypot(a2, two[2]);
  const double h1 = hue(a1, one[2]), h2 = hue(a2, two[2]);
  const bool grey = c1 * c2 == 0;
  const double dl = two[0] - one[0], dc = c2 - c1;
  const double dh = 2 * std::sqrt(c1 * c2) * std::sin(radians(hue_step(h1, h2, grey) / 2));
  const double l = (one[0] + two[0]) / 2, c = (c1 + c2) / 2, h = mean_hue(h1, h2, grey);
  const double t = 1 - 0.17 * std::cos(radians(h - 30)) + 0.24 * std::cos(radians(2 * h)) +
                   0.32 * std::cos(radians(3 * h + 6)) - 0.20 * std::cos(radians(4 * h - 63));
  const double sl = 1 + 0.015 * (l - 50) * (l - 50) / std::sqrt(20 + (l - 50) * (l - 50));
  const double sc = 1 + 0.045 * c, sh = 1 + 0.015 * c * t;
  const double turn = 30 * std::exp(-std::pow((h - 275) / 25, 2));
  const double rt = -2 * chroma_weight(c) * std::sin(radians(2 * turn));
  return std::sqrt(std::pow(dl / sl, 2) + std::pow(dc / sc, 2) + std::pow(dh / sh, 2) + rt * (dc / sc) * (dh / sh));
}

const std::vector<Vision>& visions() {
  static const std::vector<Vision> all{
      {"full colour vision", {1, 0, 0, 0, 1, 0, 0, 0, 1}},
      {"protanopia", {0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998}},
      {"deuteranopia", {0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881}},
      {"tritanopia", {1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.303900}}};
  return all;
}

Lab seen(const Vision& vision, const Rgb& color) {
  const std::array<double, 3> linear{to_linear(color.red), to_linear(color.green), to_linear(color.blue)};
  std::array<double, 3> simulated{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) simulated[i] += vision.matrix[3 * i + k] * linear[k];
    simulated[i] = std::clamp(simulated[i], 0.0, 1.0);
  }
  return to_lab(simulated);
}

double least_difference(const Rgb& one, const Rgb& two) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vision& vision : visions()) least = std::min(least, ciede2000(seen(vision, one), seen(vision, two)));
  return least;
}

}  // namespace gvd::test
