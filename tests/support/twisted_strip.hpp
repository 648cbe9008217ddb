#pragma once

#include <cmath>
#include <cstdint>

#include "gvd/soup.hpp"

namespace gvd::test {

inline constexpr int kTwist = 7;

/// A closed strip of n x 7 quads, each cut into two triangles, with a half twist: its ends meet along seven edges,
/// where orientations disagree. `closed`: its long sides are joined too, so that it is a Klein bottle (which crosses
/// itself); else it is a Moebius strip.
inline PolygonSoup make_twisted_strip(int n, bool closed) {
  constexpr double kTurn = 6.283185307179586;
  const int columns = closed ? kTwist : kTwist + 1;
  PolygonSoup soup;
  for (int i = 0; i < n; ++i) {
    const double u = kTurn * i / n;
    for (int j = 0; j < columns; ++j) {
      const double v = kTurn * j / kTwist;
      const double across = closed ? std::sin(v) : 0.6 * j / kTwist - 0.3, up = closed ? std::sin(2 * v) : 0;
      const double r = 2 + std::cos(u / 2) * across - std::sin(u / 2) * up;
      soup.positions.emplace_back(r * std::cos(u), r * std::sin(u), std::sin(u / 2) * across + std::cos(u / 2) * up);
    }
  }
  const auto vertex = [&](int i, int j) {
    return i < n ? columns * i + j % columns : (kTwist - j) % columns;  // the end meets the beginning reversed
  };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < kTwist; ++j) {
      const int a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1), d = vertex(i, j + 1);
      for (const int v : {a, b, c, a, c, d}) soup.corners.push_back(v);
      for (int triangle = 0; triangle < 2; ++triangle) soup.first_corner.push_back(soup.first_corner.back() + 3);
    }
  }
  return soup;
}

/// Splits the first triangles of a soup into three: each gets three edges more.
inline void split_triangles(PolygonSoup& soup, int count) {
  for (int f = 0; f < count; ++f) {
    const auto m = std::int32_t(soup.positions.size());
    const std::int32_t a = soup.corners[3 * f], b = soup.corners[3 * f + 1], c = soup.corners[3 * f + 2];
    soup.positions.push_back((soup.positions[a] + soup.positions[b] + soup.positions[c]) / 3);
    soup.corners[3 * f + 2] = m;
    for (const std::int32_t v : {b, c, m, c, a, m}) soup.corners.push_back(v);
    for (int triangle = 0; triangle < 2; ++triangle) soup.first_corner.push_back(soup.first_corner.back() + 3);
  }
}

}  // namespace gvd::test
