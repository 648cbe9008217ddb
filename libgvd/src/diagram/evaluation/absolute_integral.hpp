#pragma once

#include <array>

namespace gvd {

/// The four Gauss-Lobatto points of [0, 1]. The ends are among them, so neighbouring intervals share their samples.
inline constexpr std::array<double, 4> kLobattoNodes{0, 0.27639320225002103036, 0.72360679774997896964, 1};

/// The integral over [0, 1] of |f| from the samples of f at kLobattoNodes.
///
/// The cubic through the samples is cut at its roots and each piece integrated exactly. Where nothing is cut, that is
/// the Gauss-Lobatto rule itself.
/// Properties: (1) where the samples do not change sign, exact for every f of degree 5 or less that does not either;
/// (2) where they do, exact for f of degree 3 or less whose roots the samples separate. Cost: O(1).
double integrate_absolute(const std::array<double, 4>& samples);

}  // namespace gvd
