#include <fmt/format.h>

#include <limits>

#include "common/command.hpp"
#include "common/numbers.hpp"
#include "common/pipeline.hpp"
#include "gvd/generator_list.hpp"
#include "gvd/lloyd.hpp"

namespace {

using namespace gvd;

constexpr const char* kExamples =
    "  gvd-lloyd bunny.obj -n 30 -o relaxed.txt\n"
    "  gvd-lloyd bunny.obj --generators samples.csv --iterations 200 --tolerance 1e-7 -o relaxed.json\n"
    "  gvd-lloyd bunny.obj -n 30 -o relaxed.txt -o cells.ply --view cells.html --report report.json\n"
    "  gvd-lloyd bunny.obj -n 30 -o relaxed.txt && gvd-remesh bunny.obj --generators relaxed.txt -o coarse.obj\n";

constexpr app::Range<std::int32_t> kIterations{0, 1000000, "a whole number from 0 to 1000000"};
// The largest double below 2: the step must stay below it.
constexpr app::Range<double> kStep{std::numeric_limits<double>::min(), 0x1.fffffffffffffp0, "above 0 and below 2"};

const char* name(LloydStop stop) {
  switch (stop) {
    case LloydStop::centroids:
      return "centroids";
    case LloydStop::energy:
      return "energy";
    case LloydStop::no_descent:
      return "no descent";
    case LloydStop::max_iterations:
      return "iterations";
  }
  return "";
}

const char* description(LloydStop stop) {
  switch (stop) {
    case LloydStop::centroids:
      return "every generator is at its centroid";
    case LloydStop::energy:
      return "the energy falls by less than the tolerance";
    case LloydStop::no_descent:
      return "no step lowers the energy any more";
    case LloydStop::max_iterations:
      return "the iterations are used up";
  }
  return "";
}

void register_options(CLI::App& cli, LloydOptions& options) {
  const std::string group = "Relaxation";
  app::add_number<std::int32_t>(cli, "--iterations", options.max_iterations, kIterations,
                                fmt::format("Largest number of iterations (default: {})", options.max_iterations))
      ->group(group);
  app::add_number<double>(cli, "--tolerance", options.energy_tolerance, app::kNotNegative,
                          fmt::format("Stop once an iteration lowers the energy by less than this part of it "
                                      "(default: {})",
                                      options.energy_tolerance))
      ->group(group);
  app::add_number<double>(cli, "--move-tolerance", options.move_tolerance, app::kNotNegative,
                          fmt::format("Stop once no generator is farther from its centroid than this part of the mean "
                                      "cell radius (default: {})",
                                      options.move_tolerance))
      ->group(group);
  app::add_number<double>(
      cli, "--step", options.step, kStep,
      fmt::format("Part of the way to its centroid that a generator goes, below 2 (default: {})", options.step))
      ->group(group);
}

void report_relaxation(app::Run& run, const LloydResult& result) {
  auto& results = run.results();
  auto energies = nlohmann::ordered_json::array({result.initial_energy});
  auto largest = nlohmann::ordered_json::array(), mean = largest, scales = largest, held = largest;
  for (const LloydIteration& i : result.iterations) {
    energies.push_back(i.energy);
    largest.push_back(i.largest_move);
    mean.push_back(i.mean_move);
    scales.push_back(i.scale);
    held.push_back(i.held);
  }
  results["iterations"] = result.iterations.size();
  results["stop"] = name(result.stop);
  results["energies"] = std::move(energies);
  results["largest_moves"] = std::move(largest);
  results["mean_moves"] = std::move(mean);
  results["step_scales"] = std::move(scales);
  results["held_generators"] = std::move(held);
  results["residual"] = result.residual;
  results["mean_cell_radius"] = result.mean_cell_radius;
  results["diagrams"] = result.diagrams;
  run.console().note(fmt::format("{} iterations, energy {:.6g} -> {:.6g}: {}", result.iterations.size(),
                                 result.initial_energy, result.final_energy, description(result.stop)));
}

void report_options(app::Run& run, const LloydOptions& options) {
  auto& reported = run.reported_options();
  reported["iterations"] = options.max_iterations;
  reported["tolerance"] = options.energy_tolerance;
  reported["move_tolerance"] = options.move_tolerance;
  reported["step"] = options.step;
}

LloydResult relax(app::Run& run, const Mesh& mesh, const std::vector<SurfacePoint>& start, LloydOptions options) {
  options.diagram = app::make_diagram_options(run.options().compute);
  options.progress = run.progress();
  LloydResult result = run.timed("relaxation", [&] { return relax_generators(mesh, start, options); });
  report_relaxation(run, result);
  // The report lists what the run leaves: its list of generators reads back like the others.
  run.report().generators.clear();
  for (const SurfacePoint& p : result.generators) {
    run.report().generators.push_back({p, position(mesh, p), std::nullopt});
  }
  return result;
}

void write_outputs(app::Run& run, const Mesh& mesh, const Diagram& diagram) {
  LabelledMesh output{mesh};
  output.face_label = &diagram.face_label;
  output.vertex_label = &diagram.vertex_label;
  output.vertex_distance = &diagram.vertex_distance;
  output.diagram = &diagram;
  const auto list = [&](GeneratorFormat format) {
    return [&mesh, &diagram, format](std::ostream& out) { out << format_generators(mesh, diagram.generators, format); };
  };
  app::write_output_files(run, output, {{"txt", list(GeneratorFormat::text)}, {"csv", list(GeneratorFormat::csv)}});
}

/// Where the generators have come to, and where they came from.
std::vector<ViewScene> scenes(const Mesh& mesh, const std::vector<SurfacePoint>& start, const LloydResult& relaxed,
                              const DiagramOptions& options) {
  std::vector<ViewScene> both{make_view_scene("Relaxed", mesh, relaxed.diagram),
                              make_view_scene("Start", mesh, compute_diagram(mesh, start, options))};
  both[0].figures.push_back({"Energy", fmt::format("{:.6g}", relaxed.final_energy)});
  both[1].figures.push_back({"Energy", fmt::format("{:.6g}", relaxed.initial_energy)});
  both[0].figures.push_back({"Iterations", fmt::format("{}", relaxed.iterations.size())});
  both[0].figures.push_back({"Stopped by", name(relaxed.stop)});
  return both;
}

void lloyd(app::Run& run, const LloydOptions& options) {
  report_options(run, options);
  const CheckedMesh input = app::load_input(run);
  const Mesh& mesh = input.mesh;
  const std::vector<SurfacePoint> start = app::make_generators(run, input);
  const LloydResult relaxed = relax(run, mesh, start, options);
  const Diagram diagram = app::build_diagram(run, mesh, relaxed.generators);
  write_outputs(run, mesh, diagram);
  app::write_diagram_file(run, mesh, diagram);
  app::write_view_file(run, "gvd-lloyd", [&] {
    DiagramOptions start_options = app::make_diagram_options(run.options().compute);
    start_options.progress = run.progress();
    return scenes(mesh, start, relaxed, start_options);
  });
  app::verify(run, mesh, diagram);
  app::write_report_file(run);
}

}  // namespace

int main(int argc, char** argv) {
  LloydOptions options;
  app::Command command({"gvd-lloyd",
                        "Moves generators to the geodesic centroids of their regions until they rest.",
                        kExamples,
                        {"txt", "csv", "json", "ply", "obj", "off", "stl", "vtp", "glb"}});
  register_options(command.cli(), options);
  return command.run(argc, argv, [&](app::Run& run) { lloyd(run, options); });
}
