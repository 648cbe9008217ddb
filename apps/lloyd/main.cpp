// gvd-lloyd: relaxes generators and writes them.

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "common/options/register_options.hpp"
#include "common/options/typed_options.hpp"
#include "common/relaxation/constrain_start.hpp"
#include "common/run/command.hpp"
#include "common/steps/build_diagram.hpp"
#include "common/steps/load_input.hpp"
#include "common/steps/verify.hpp"
#include "common/steps/write_outputs.hpp"
#include "gvd/generator_list.hpp"
#include "gvd/io/point_writer.hpp"
#include "gvd/lloyd.hpp"
#include "lloyd/iteration_scenes.hpp"
#include "lloyd/lloyd_report.hpp"
#include "lloyd/relaxation_trace.hpp"
#include "lloyd/timer.hpp"

namespace {

using namespace gvd;

constexpr const char* kExamples =
    "  gvd-lloyd bunny.obj -n 30 -o relaxed.txt\n"
    "  gvd-lloyd bunny.obj --generators samples.csv --iterations 200 -o relaxed.json\n"
    "  gvd-lloyd bunny.obj -n 30 -o relaxed.txt -o cells.ply --view cells.html\n"
    "  gvd-lloyd bunny.obj -n 100 --time-limit 5 --points samples.ply\n"
    "  gvd-lloyd bunny.obj -n 30 -o relaxed.txt &&\n"
    "    gvd-remesh bunny.obj --generators relaxed.txt -o coarse.obj\n"
    "  gvd-lloyd scans/*.stl -n 30 --output-dir relaxed --output-format json\n";

constexpr app::Range<std::int32_t> kIterations{0, 1000000, "a whole number from 0 to 1000000"};
// The upper end is the largest double below 2.
constexpr app::Range<double> kStep{std::numeric_limits<double>::min(), 0x1.fffffffffffffp0, "above 0 and below 2"};

void register_relaxation(CLI::App& line, app::OwnOptions& own) {
  LloydOptions &options = own.relaxation, plain;
  plain.acceleration = Acceleration::none;
  line.option_defaults()->group("Relaxation");
  app::add_choice(
      line, "--accelerate", options.acceleration, app::acceleration_names(),
      "How steps are found: by a quasi-Newton method (lbfgs, the default), by Anderson's mixing of the last "
      "steps, or by Lloyd's method alone");
  app::add_choice(line, "--relocate", options.relocate, app::Choices<bool>{{"on", true}, {"off", false}},
                  "Move generators from cells with little energy to distant cells with much, where that lowers the "
                  "energy at once (default: on, with --accelerate none off)");
  app::add_number(line, "--iterations", options.max_iterations, kIterations,
                  fmt::format("Largest number of iterations (default: {}, with --accelerate none {})",
                              max_iterations(options), max_iterations(plain)));
  app::add_number(line, "--tolerance", options.energy_tolerance, app::kNotNegative,
                  fmt::format("Stop once iterations lower the energy by less than this fraction of it (default: {}, "
                              "with --accelerate none {}); 1e-5 saves about half of the time",
                              energy_tolerance(options), energy_tolerance(plain)));
  app::add_number(line, "--move-tolerance", options.move_tolerance, app::kNotNegative,
                  fmt::format("Stop once no generator is farther from its centroid than this fraction of the mean cell "
                              "radius (default: {})",
                              options.move_tolerance));
  app::add_number(
      line, "--step", options.step, kStep,
      fmt::format("Length of Lloyd's steps, as a fraction of the way to the centroid, below 2 (default: {})",
                  options.step));
  app::add_number(line, "--time-limit", own.time_limit, app::kNotNegative,
                  "Stop after the iteration in which the relaxation has taken this many seconds; the result then "
                  "differs between runs (default: none)");
}

/// The progress of a relaxation that also ends after `limit` seconds.
Progress limit_progress(const Progress& progress, const app::Timer& timer, double limit) {
  return [progress, &timer, limit](std::string_view step, double fraction) {
    return progress(step, std::max(fraction, std::min(1.0, timer.seconds() / limit)));
  };
}

LloydResult relax(app::Run& run, const Mesh& mesh, const app::ConstrainedStart& start, const app::OwnOptions& own,
                  app::RelaxationTrace& trace) {
  LloydOptions options = own.relaxation;
  options.freedom = start.freedom;
  options.creases = start.creases;
  options.density = start.density;
  options.diagram = app::make_diagram_options(run.options().compute);
  const app::Timer timer;
  trace = {};
  if (own.time_limit) options.is_time_over = [&] { return timer.seconds() >= *own.time_limit; };
  options.progress = own.time_limit ? limit_progress(run.progress(), timer, *own.time_limit) : run.progress();
  options.on_iteration = [&, most = max_iterations(options)](std::int64_t iterations, double energy,
                                                             const std::vector<SurfacePoint>& generators) {
    trace.note(iterations, generators);
    run.console().set_status(fmt::format("{}/{}, energy {:.6g}", iterations, most, energy));
  };
  LloydResult result = run.timed("relaxation", [&] { return relax_generators(mesh, start.points, options); });
  run.console().set_status("");
  app::report_relaxation(run, mesh, result);
  app::report_diagram(run, result.diagram);
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

void write_points_file(app::Run& run, const Mesh& mesh, const LloydResult& relaxed) {
  const auto format = parse_point_format(app::file_extension(run.options().output.own.at("--points")));
  if (!format) return;
  std::vector<SurfaceSample> samples;
  for (const SurfacePoint& point : relaxed.generators) {
    const CellMoments& moments = relaxed.moments[GeneratorId(std::ssize(samples))];
    samples.push_back({point, moments.area, moments.energy});
  }
  app::write_own_file(run, "--points", [&](std::ostream& out) { write_points(out, mesh, samples, *format); });
}

void lloyd(app::Run& run, const app::OwnOptions& own) {
  app::report_lloyd_options(run, own);
  const CheckedMesh input = app::load_input(run);
  const Mesh& mesh = input.mesh;
  const app::ConstrainedStart start = app::make_start(run, input, own.constraints);
  app::RelaxationTrace trace;
  const LloydResult relaxed = relax(run, mesh, start, own, trace);
  write_outputs(run, mesh, relaxed.diagram);
  app::write_diagram_file(run, mesh, relaxed.diagram);
  write_points_file(run, mesh, relaxed);
  app::write_own_file(run, "--trace",
                      [&](std::ostream& out) { trace.write(out, relaxed, run.options().compute.method); });
  app::write_view_file(run, "gvd-lloyd", [&] {
    DiagramOptions early = app::make_diagram_options(run.options().compute);
    early.progress = run.progress();
    return app::make_iteration_scenes(mesh, relaxed, trace, early);
  });
  app::verify(run, mesh, relaxed.diagram);
  app::write_report_file(run);
}

}  // namespace

int main(int argc, char** argv) {
  app::OwnOptions own;
  app::Command command({"gvd-lloyd",
                        "Moves generators to the geodesic centroids of their cells until they stop moving.",
                        kExamples,
                        {"txt", "csv", "json", "ply", "obj", "off", "stl", "vtp", "glb"}});
  register_relaxation(command.line(), own);
  app::register_constraints(command.line(), own.constraints);
  command.add_target(
      "--points", "FILE",
      "Write the generators with normals, barycentric coordinates, areas and energies (.ply, .xyz, .npy)",
      {"ply", "xyz", "npy"});
  command.add_target("--trace", "FILE.csv", "Write energy, moves, methods and seconds of each iteration as CSV");
  return command.run(argc, argv, [&](app::Run& run) { lloyd(run, own); });
}
