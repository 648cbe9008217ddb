#include "lloyd/iteration_scenes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

#include "common/relaxation/relaxation_report.hpp"

namespace gvd::app {
namespace {

/// Scenes of a page: each costs a diagram, and about as many bytes as a page with one.
constexpr std::size_t kMostScenes = 12;

/// Least chord tolerance between start and end, in mean edge lengths: pages are a quarter smaller than with the
/// default.
constexpr double kCoarseChords = 0.05;

DiagramOptions coarse(DiagramOptions options) {
  options.chord_tolerance = std::max(kCoarseChords, options.chord_tolerance);
  return options;
}

ViewScene make_scene(const Mesh& mesh, const Diagram& diagram, std::string name, double energy) {
  ViewScene scene = make_view_scene(std::move(name), mesh, diagram);
  scene.figures.push_back({"Energy", fmt::format("{:.6g}", energy)});
  return scene;
}

double energy_after(const LloydResult& relaxed, std::size_t iterations) {
  return iterations == 0 ? relaxed.initial_energy : relaxed.iterations[iterations - 1].energy;
}

}  // namespace

std::vector<ViewScene> make_iteration_scenes(const Mesh& mesh, const LloydResult& relaxed, const RelaxationTrace& trace,
                                             const DiagramOptions& options) {
  const std::size_t last = relaxed.iterations.size(), gaps = std::min(kMostScenes - 1, std::max<std::size_t>(last, 1));
  std::vector<ViewScene> scenes{make_scene(mesh, relaxed.diagram, "Relaxed", relaxed.final_energy)};
  scenes[0].figures.push_back({"Iterations", fmt::format("{}", last)});
  scenes[0].figures.push_back({"Stopped by", name_of(relaxed.stop)});
  if (last > 0) scenes[0].iteration = static_cast<std::int64_t>(last);
  for (std::size_t k = 0; k < gaps; ++k) {
    const std::size_t iterations = (k * last + gaps / 2) / gaps;  // rounded to the nearest
    const Diagram diagram = compute_diagram(mesh, trace.generators(iterations), k == 0 ? options : coarse(options));
    scenes.push_back(make_scene(mesh, diagram, k == 0 ? "Start" : "", energy_after(relaxed, iterations)));
    if (last > 0) scenes.back().iteration = static_cast<std::int64_t>(iterations);
  }
  return scenes;
}

}  // namespace gvd::app
