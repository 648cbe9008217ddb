#pragma once

#include <array>

namespace gvd {

/// The four Gauss-Lobatto points of [0, 1]. They include the ends, so that neighbouring intervals share samples.
inline constexpr std::array<double, 4> kLobattoNodes{0, 0.27639320225002103036, 0.72360679774997896964, 1};

/// Computes the integral of |f| over [0, 1] from the samples of f at kLobattoNodes.
///
/// The cubic through the samples is split at its roots, and each piece is integrated exactly. If there is no root, this
/// is the Gauss-Lobatto rule.
/// Properties: (1) exact for every f of degree 5 or less without a change of sign; (2) exact for every f of degree 3 or
/// less whose roots the samples separate. Cost: O(1).
double integrate_absolute(const std::array<double, 4>& samples);

}  // namespace gvd
