// The options as the library and the report take them, and the texts of users that every step on the way handles:
// names of files, and texts that messages repeat. Everything here is the same in any locale.

#include "common/options/options.hpp"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "gvd/io/mesh_writer.hpp"

namespace gvd::app {
namespace {

using Json = nlohmann::ordered_json;

void add_generators(Json& json, const GeneratorOptions& generators) {
  json["n"] = or_null(generators.count);
  json["sampling"] = name_in(kSamplingNames, generators.sampling);
  json["seed"] = generators.seed;
  json["generators"] = or_null(generators.file);
  json["generators_format"] = generators.format ? Json(name_in(kGeneratorFormatNames, *generators.format)) : Json();
  json["vertices"] = or_null(generators.vertices);
  json["radius"] = or_null(generators.radius);
  json["max_snap"] = or_null(generators.max_snap);
  json["merge_coincident"] = generators.merge_coincident;
}

/// A list as the command line gives it: the file, or vertices.
Json list_of(const GeneratorOptions& list) { return list.vertices ? Json(*list.vertices) : or_null(list.file); }

void add_lists(Json& json, const Options& options) {
  json["from"] = list_of(options.generators);
  json["curves"] = or_null(options.generators.curves);
  json["to"] = list_of(options.targets);
  json["max_snap"] = or_null(options.generators.max_snap);
  json["merge_coincident"] = options.generators.merge_coincident;
}

void add_method(Json& json, const ComputeOptions& compute) {
  const DiagramOptions diagram = make_diagram_options(compute);
  const bool exact = compute.method == Method::exact;
  json["method"] = name_in(kMethodNames, compute.method);
  json["chord_tolerance"] = exact ? Json(diagram.chord_tolerance) : Json();
  json["front"] = exact ? Json() : Json(name_in(kFrontNames, diagram.chosen_front()));
}

void add_output(Json& json, const Options& options) {
  const OutputOptions& output = options.output;
  json["output"] = output.files;
  if (options.has_diagram) json["no_curves"] = output.no_curves;
  json["ascii_ply"] = output.ascii_ply;
  if (options.has_diagram) json["diagram"] = or_null(output.diagram);
  json["view"] = or_null(output.view);
  json["up"] = output.up ? Json(name_in(kUpAxisNames, *output.up)) : Json();
  json["report"] = or_null(output.report);
}

}  // namespace

std::string format_of(const OutputOptions& output, const std::string& file) {
  const std::string asked = output.formats.empty() ? "" : output.formats.front();
  if (file == "-") return asked;
  const std::string extension = file_extension(file);
  const bool is_known = parse_output_format(extension) || contains({"npy", "csv", "txt"}, extension);
  return asked == kFreeSurfer && !is_known ? asked : extension;
}

std::vector<std::string> written_formats(const OutputOptions& output) {
  std::vector<std::string> written;
  if (!output.folder.empty()) written = output.formats;
  for (const std::string& file : output.files) written.push_back(format_of(output, file));
  return written;
}

std::vector<Target> list_targets(const OutputOptions& output) {
  std::vector<Target> targets;
  for (const std::string& file : output.files) targets.push_back({output.folder.empty() ? "-o" : "--output-dir", file});
  targets.push_back({"--report", output.report});
  targets.push_back({"--diagram", output.diagram});
  targets.push_back({"--view", output.view});
  for (const auto& [option, file] : output.own) targets.push_back({option, file});
  std::erase_if(targets, [](const Target& target) { return target.path.empty(); });
  return targets;
}

bool names_file(const OutputOptions& output) {
  const bool has_own =
      std::any_of(output.own.begin(), output.own.end(), [](const auto& own) { return !own.second.empty(); });
  return has_own || output.open || !output.files.empty() || !output.folder.empty() || !output.report.empty() ||
         !output.diagram.empty() || !output.view.empty();
}

DiagramOptions make_diagram_options(const ComputeOptions& compute) {
  DiagramOptions options;
  options.method = compute.method;
  options.front = compute.front;
  options.chord_tolerance = compute.chord_tolerance.value_or(options.chord_tolerance);
  options.threads = compute.threads;
  return options;
}

Json or_null(const std::string& text) { return text.empty() ? Json() : Json(text); }

Json to_json(const Options& options) {
  Json json = Json::object();
  json["input"] = options.input.path;
  json["input_format"] = options.input.format ? Json(name_in(kMeshFormatNames, *options.input.format)) : Json();
  json["on_defect"] = name_in(kDefectPolicyNames, options.input.on_defect);
  json["weld"] = options.input.weld ? Json(*options.input.weld) : Json();
  if (options.has_diagram) {
    add_generators(json, options.generators);
    add_method(json, options.compute);
  } else {
    add_lists(json, options);
  }
  json["threads"] = options.compute.threads;
  if (options.has_diagram) json["verify"] = options.compute.verify;
  json["max_memory"] = or_null(options.compute.max_memory);
  add_output(json, options);
  return json;
}

bool is_read_once(const std::string& file) {
  std::error_code ignored;
  const auto status = std::filesystem::status(file, ignored);
  return file == "-" || (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status) &&
                         !std::filesystem::is_directory(status));
}

std::string file_extension(const std::string& path) { return format_extension(path); }

bool contains(const std::vector<std::string>& texts, const std::string& text) {
  return std::find(texts.begin(), texts.end(), text) != texts.end();
}

std::string printable(std::string text, std::size_t longest) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return (c >= 0 && c < ' ') || c == 127; }, ' ');
  if (text.size() <= longest) return text;
  std::size_t end = longest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;  // no half character of UTF-8
  return text.substr(0, end) + "...";
}

}  // namespace gvd::app
