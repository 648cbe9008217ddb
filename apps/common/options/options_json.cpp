#include "common/options/options_json.hpp"

#include <nlohmann/json.hpp>

namespace gvd::app {
namespace {

using Json = nlohmann::ordered_json;

const char* name_of(SamplingKind kind) {
  switch (kind) {
    case SamplingKind::random:
      return "random";
    case SamplingKind::vertices:
      return "vertices";
    case SamplingKind::poisson:
      return "poisson";
    case SamplingKind::farthest:
      break;
  }
  return "farthest";
}

const char* name_of(GeneratorFormat format) {
  switch (format) {
    case GeneratorFormat::csv:
      return "csv";
    case GeneratorFormat::json:
      return "json";
    case GeneratorFormat::text:
      break;
  }
  return "text";
}

template <class T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json();
}

Json or_null(const std::string& text) { return text.empty() ? Json() : Json(text); }

void add_input(Json& json, const InputOptions& input) {
  json["input"] = input.path;
  json["input_format"] = or_null(input.format);
  json["on_defect"] = input.on_defect;
}

void add_generators(Json& json, const GeneratorOptions& generators) {
  json["n"] = or_null(generators.count);
  json["sampling"] = name_of(generators.sampling);
  json["seed"] = generators.seed;
  json["generators"] = or_null(generators.file);
  json["generators_format"] = generators.format ? Json(name_of(*generators.format)) : Json();
  json["vertices"] = or_null(generators.vertices);
  json["radius"] = or_null(generators.radius);
  json["max_snap"] = or_null(generators.max_snap);
  json["merge_coincident"] = generators.merge_coincident;
}

void add_compute(Json& json, const ComputeOptions& compute) {
  const DiagramOptions diagram = make_diagram_options(compute);
  const bool exact = compute.method == Method::exact;
  json["method"] = method_name(compute.method);
  json["chord_tolerance"] = exact ? Json(diagram.chord_tolerance) : Json();
  json["front"] = exact ? Json() : Json(diagram.front == Front::planar ? "planar" : "circle");
  json["threads"] = compute.threads;
  json["verify"] = compute.verify;
  json["max_memory"] = or_null(compute.max_memory);
}

void add_output(Json& json, const OutputOptions& output) {
  json["output"] = output.files;
  json["no_curves"] = output.no_curves;
  json["ascii_ply"] = output.ascii_ply;
  json["diagram"] = or_null(output.diagram);
  json["view"] = or_null(output.view);
  json["up"] = output.up ? Json(to_text(*output.up)) : Json();
  json["report"] = or_null(output.report);
}

}  // namespace

const char* method_name(const Method& method) {
  if (method == Method::exact) return "exact";
  return method == Method::paper ? "paper" : "gbgvd";
}

Json to_json(const Options& options) {
  Json json = Json::object();
  add_input(json, options.input);
  add_generators(json, options.generators);
  add_compute(json, options.compute);
  add_output(json, options.output);
  return json;
}

}  // namespace gvd::app
