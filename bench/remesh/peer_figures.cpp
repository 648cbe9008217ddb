#include "peer_figures.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>

namespace gvd::bench {
namespace {

/// Differences below this fraction of the best figure are none.
constexpr double kLevel = 1e-6;

}  // namespace

std::vector<PeerRow> peer_figures(int vertices) {
  switch (vertices) {
    case 100:
      return {{"topology right, of 9", false, {8, 8, 4}},   {"worst vertices / n", true, {2.26, 2.00, 1.59}},
              {"mean Hausdorff, %", true, {4.9, 4.2, 9.8}}, {"mean RMS, %", true, {1.03, .82, 1.68}},
              {"mean Q", false, {.844, .832, .882}},        {"CPU, s", true, {}},
              {"creases kept, %", false, {4, 45, 10}}};
    case 500:
      return {{"topology right, of 9", false, {8, 8, 7}},   {"worst vertices / n", true, {1.16, 1.08, 1.82}},
              {"mean Hausdorff, %", true, {2.2, 1.8, 2.7}}, {"mean RMS, %", true, {.32, .24, .26}},
              {"mean Q", false, {.846, .824, .904}},        {"CPU, s", true, {std::nullopt, 6.2, std::nullopt}},
              {"creases kept, %", false, {10, 2, 54}}};
    case 2000:
      return {{"topology right, of 9", false, {8, 8, 8}},    {"worst vertices / n", true, {1, 1, 1.82}},
              {"mean Hausdorff, %", true, {.90, .69, 1.07}}, {"mean RMS, %", true, {.109, .070, .079}},
              {"mean Q", false, {.846, .819, .914}},         {"CPU, s", true, {std::nullopt, 13.1, std::nullopt}},
              {"creases kept, %", false, {66, 100, 95}}};
    default:
      return {};
  }
}

std::string compare_with_best(double ours, const PeerRow& peers) {
  std::optional<std::size_t> best;
  const auto is_better = [&](double a, double b) { return peers.smaller_is_better ? a < b : a > b; };
  for (std::size_t i = 0; i < kPeers.size(); ++i) {
    if (peers.values[i] && (!best || is_better(*peers.values[i], *peers.values[*best]))) best = i;
  }
  if (!best) return {};
  const double value = *peers.values[*best], difference = std::abs(ours - value);
  if (difference <= kLevel * std::abs(value)) return "level";
  if (is_better(ours, value)) return fmt::format("ahead by {:.3g}", difference);
  return fmt::format("behind {} by {:.3g}", kPeers[*best], difference);
}

}  // namespace gvd::bench
