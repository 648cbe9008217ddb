#include "own_scales.hpp"

#include "integrals/cell_faces.hpp"

namespace gvd {
namespace {

/// The largest number of halvings: down to a thousandth.
constexpr int kHalvings = 10;

}  // namespace

std::vector<double> find_own_scales(const GeneratorConstraints& constraints, const RelaxationState& state, double step,
                                    CellIntegrals& integrals, const std::function<void()>& report) {
  const CellFaces cells(state.diagram);
  std::vector<double> scales;
  for (std::size_t i = 0; i < state.generators.size(); ++i) {
    report();
    const GeneratorId g(static_cast<std::int64_t>(i));
    double scale = step;
    int halvings = 0;
    const double before = integrals.compute(state.generators[i], cells.of(g)).energy;
    const auto lowers = [&] {
      const SurfacePoint to =
          constraints.move(integrals.mesh(), i, state.generators[i], scale * state.to_centroids[i]).points.back();
      return integrals.compute(to, cells.of(g)).energy < before;
    };
    while (scale > 0 && !lowers()) scale = ++halvings > kHalvings ? 0 : 0.5 * scale;
    scales.push_back(scale);
  }
  return scales;
}

}  // namespace gvd
