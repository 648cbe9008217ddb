// Measurements of several methods on one mesh, with generators of several seeds.
//
// Times are medians of processor time, errors are means. All methods of a run have the same generators. The peak of the
// heap is counted in a run of its own, because counting takes time.
#include "measure.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "baseline.hpp"
#include "clocks.hpp"
#include "heap_meter.hpp"
#include "judge.hpp"

namespace gvd::paper {
namespace {

/// The figures of each run.
struct Samples {
  std::vector<double> field_ms, diagram_ms, error, turn, islands, open_ends;
};

std::vector<SurfacePoint> draw_generators(const Mesh& mesh, int count, int seed) {
  std::vector<SurfacePoint> generators;
  for (const VertexId v : bench::draw_vertices(mesh, count, static_cast<std::uint64_t>(seed))) {
    generators.push_back(vertex_point(mesh, v));
  }
  return generators;
}

void add_sample(const Comparison& result, const Judge* judge, Samples& samples) {
  samples.field_ms.push_back(result.field_ms);
  samples.diagram_ms.push_back(result.diagram_ms);
  samples.islands.push_back(double(result.faults.islands));
  samples.open_ends.push_back(double(result.faults.open_ends));
  if (judge == nullptr) return;
  const Judgement found = judge->judge(result.diagram);
  samples.error.push_back(found.error.error_integral);
  samples.turn.push_back(found.error.length > 0 ? found.turning_angle / found.error.length : 0);
}

double count_kilobytes(const Experiment& experiment, const Comparator& method) {
  const auto generators = draw_generators(experiment.mesh, experiment.generators, 0);
  const bench::HeapMeter meter;
  const Comparison result = method.run(experiment.mesh, generators);
  return double(meter.peak()) / 1024;
}

Measurement condense(const std::string& method, const Samples& samples) {
  Measurement result;
  result.method = method;
  result.field_ms = bench::median(samples.field_ms);
  result.diagram_ms = bench::median(samples.diagram_ms);
  result.error = summarize(samples.error);
  result.errors = samples.error;
  result.turn_per_length = summarize(samples.turn).mean;
  result.islands = summarize(samples.islands).mean;
  result.open_ends = summarize(samples.open_ends).mean;
  return result;
}

}  // namespace

Statistic summarize(const std::vector<double>& values) {
  if (values.empty()) return {};
  Statistic result;
  const auto count = double(values.size());
  for (const double value : values) result.mean += value / count;
  double squares = 0;
  for (const double value : values) squares += (value - result.mean) * (value - result.mean);
  if (values.size() > 1) result.deviation = std::sqrt(squares / (count - 1));
  result.least = *std::min_element(values.begin(), values.end());
  result.most = *std::max_element(values.begin(), values.end());
  return result;
}

std::vector<Measurement> measure(const Experiment& experiment, const std::vector<Comparator>& methods) {
  std::vector<Samples> samples(methods.size());
  for (int run = 0; run < experiment.runs; ++run) {
    const auto generators = draw_generators(experiment.mesh, experiment.generators, run);
    std::optional<Judge> judge;
    if (experiment.errors) judge.emplace(experiment.mesh, generators);
    for (std::size_t i = 0; i < methods.size(); ++i) {
      add_sample(methods[i].run(experiment.mesh, generators), judge ? &*judge : nullptr, samples[i]);
    }
  }
  std::vector<Measurement> all;
  for (std::size_t i = 0; i < methods.size(); ++i) {
    all.push_back(condense(methods[i].name, samples[i]));
    if (experiment.memory) all.back().memory_kb = count_kilobytes(experiment, methods[i]);
  }
  return all;
}

std::vector<OtherMeasurement> measure_others(const Experiment& experiment, const std::vector<Comparator>& methods) {
  std::vector<OtherMeasurement> all;
  for (const Comparator& method : methods) all.push_back({method.name, 0, {}});
  for (int run = 0; run < experiment.runs; ++run) {
    const auto generators = draw_generators(experiment.mesh, experiment.generators, run);
    const Judge judge(experiment.mesh, generators);
    const OtherJudge other(experiment.mesh, generators);
    for (std::size_t i = 0; i < methods.size(); ++i) {
      const Diagram diagram = methods[i].run(experiment.mesh, generators).diagram;
      const OtherErrors found = other.judge(diagram);
      all[i].error += judge.judge(diagram).error.error_integral / experiment.runs;
      all[i].others.by_marching += found.by_marching / experiment.runs;
      all[i].others.of_face += found.of_face / experiment.runs;
      all[i].others.distance += found.distance / experiment.runs;
    }
  }
  return all;
}

}  // namespace gvd::paper
