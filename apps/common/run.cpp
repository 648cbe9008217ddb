#include "common/run.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

namespace gvd::app {
namespace {

using Json = nlohmann::ordered_json;

const char* name_of(SamplingKind kind) {
  switch (kind) {
    case SamplingKind::random:
      return "random";
    case SamplingKind::poisson:
      return "poisson";
    case SamplingKind::farthest:
      break;
  }
  return "farthest";
}

/// The options as they were understood, defaults included; what was not given is null.
Json to_json(const Options& options) {
  const auto or_null = [](const auto& value) { return value ? Json(*value) : Json(); };
  const auto text_or_null = [](const std::string& text) { return text.empty() ? Json() : Json(text); };
  const GeneratorOptions& generators = options.generators;
  const ComputeOptions& compute = options.compute;
  const DiagramOptions diagram = make_diagram_options(compute);
  const bool exact = compute.method == Method::exact;
  return {{"input", options.input.path},
          {"input_format", text_or_null(options.input.format)},
          {"on_defect", options.input.on_defect},
          {"n", or_null(generators.count)},
          {"sampling", name_of(generators.sampling)},
          {"seed", generators.seed},
          {"generators", text_or_null(generators.file)},
          {"vertices", or_null(generators.vertices)},
          {"radius", or_null(generators.radius)},
          {"max_snap", or_null(generators.max_snap)},
          {"merge_coincident", generators.merge_coincident},
          {"method", exact ? "exact" : "gbgvd"},
          {"chord_tolerance", exact ? Json(diagram.chord_tolerance) : Json()},
          {"front", exact ? Json() : Json(diagram.front == Front::planar ? "planar" : "circle")},
          {"threads", compute.threads},
          {"verify", compute.verify},
          {"output", options.output.files},
          {"diagram", text_or_null(options.output.diagram)},
          {"view", text_or_null(options.output.view)},
          {"report", text_or_null(options.output.report)}};
}

}  // namespace

DiagramOptions make_diagram_options(const ComputeOptions& compute) {
  DiagramOptions options;
  options.method = compute.method;
  options.front = compute.front.value_or(options.front);
  options.chord_tolerance = compute.chord_tolerance.value_or(options.chord_tolerance);
  options.threads = compute.threads;
  return options;
}

std::int64_t peak_memory_bytes() {
  rusage usage{};
  if (::getrusage(RUSAGE_SELF, &usage) != 0) return 0;
#ifdef __APPLE__
  return usage.ru_maxrss;
#else
  return std::int64_t{1024} * usage.ru_maxrss;  // Linux counts in kibibytes
#endif
}

Run::Run(const std::string& command, Options options, Console& console)
    : options_(std::move(options)), console_(console), reported_options_(to_json(options_)) {
  report_.command = command;
  report_.version = GVD_VERSION;
  report_.seed = options_.generators.seed;
}

Progress Run::progress() {
  return [this](std::string_view step, double fraction) {
    console_.bar(step, fraction);
    return !interrupt_requested();
  };
}

Run::Stopwatch::Stopwatch(Run& run, std::string_view step) : run_(run), step_(step) {
  check_interrupt();
  start_ = std::chrono::steady_clock::now();
}

Run::Stopwatch::~Stopwatch() {
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start_;
  run_.console_.clear_bar();
  run_.console_.detail(fmt::format("{}: {:.1f} ms", step_, taken.count()));
  run_.report_.timings_ms.emplace_back(step_, taken.count());
}

}  // namespace gvd::app
