#include "common/options/register_options.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "common/options/file_extension.hpp"
#include "common/options/parse_size.hpp"
#include "common/options/typed_options.hpp"
#include "gvd/error.hpp"

namespace gvd::app {
namespace {

constexpr Range<std::int32_t> kThreads{1, 4096, "a whole number from 1 to 4096"};

// Headings of --help.
constexpr const char *kInput = "Input", *kComputing = "Computing", *kOutput = "Output";
constexpr const char* kGenerators = "Generators (exactly one of -n, --generators, --vertices, --radius)";

/// Of the options that say where generators come from, all but `name`: one of them is given.
std::vector<std::string> sources_but(const std::string& name) {
  std::vector<std::string> others;
  for (const char* source : {"-n", "--generators", "--vertices", "--radius"}) {
    if (source != name) others.emplace_back(source);
  }
  return others;
}

/// Choices whose value is their name.
Choices<std::string> self_named(const std::vector<std::string>& names) {
  Choices<std::string> choices;
  for (const std::string& name : names) choices.emplace_back(name, name);
  return choices;
}

std::string join(const std::vector<std::string>& texts, const std::string& separator) {
  std::string joined;
  for (std::size_t i = 0; i < texts.size(); ++i) joined += (i > 0 ? separator : "") + texts[i];
  return joined;
}

std::string trim(const std::string& text) {
  constexpr const char* kBlanks = " \t\n\v\f\r";
  const std::size_t first = text.find_first_not_of(kBlanks);
  return first == text.npos ? "" : text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

bool contains(const std::vector<std::string>& texts, const std::string& text) {
  return std::find(texts.begin(), texts.end(), text) != texts.end();
}

/// The option that chooses the formats of what is written.
const char* format_option(const OutputOptions& output) {
  return !output.folder.empty() || contains(output.files, "-") ? "--output-format" : "-o";
}

/// Whether a file or standard output gets one of the formats.
bool writes_any(const OutputOptions& output, const std::vector<std::string>& formats) {
  const auto wanted = [&](const std::string& format) { return contains(formats, format); };
  if (!output.folder.empty()) return std::any_of(output.formats.begin(), output.formats.end(), wanted);
  return std::any_of(output.files.begin(), output.files.end(), [&](const std::string& file) {
    return wanted(file == "-" ? stdout_format(output) : file_extension(file));
  });
}

void register_input(CommandLine& line, InputOptions& input) {
  line.add_list({"INPUT", "",
                 "The mesh: .obj, .ply, .off or .stl; - for standard input. Several ones go with --output-dir", kInput},
                [&input](const std::vector<std::string>& paths) {
                  for (const std::string& path : paths) {
                    if (path.empty()) throw Error(ErrorCode::invalid_option, "INPUT: the name is empty; name a file");
                  }
                  input.paths = paths;
                  input.path = paths.front();
                });
  add_choice(line,
             {"--input-format", "", "The input's format; needed with -, else told from content and extension", kInput},
             input.format, self_named({"obj", "ply", "off", "stl"}));
  add_choice(line,
             {"--on-defect", "",
              "What to do about defects of the mesh: refuse, repair what loses nothing (default), or repair and keep "
              "the largest component",
              kInput},
             input.on_defect, self_named({"error", "repair", "largest"}));
}

/// Options that choose generators on the surface.
void register_sampling(CommandLine& line, GeneratorOptions& generators, bool sizes) {
  std::vector<std::string> counts{"-n"};
  if (sizes) counts.insert(counts.end(), {"--target-edge", "--error"});
  add_number(line, {"-n,--count", "", "Choose N generators", kGenerators, {}, sources_but("-n")}, generators.count,
             kCount);
  add_choice(line, {"--sampling", "", "How -n chooses (default: farthest)", kGenerators, counts}, generators.sampling,
             Choices<SamplingKind>{{"farthest", SamplingKind::farthest},
                                   {"random", SamplingKind::random},
                                   {"vertices", SamplingKind::vertices},
                                   {"poisson", SamplingKind::poisson}});
  counts.emplace_back("--radius");
  add_number(line, {"--seed", "", "Seed of the choice (default: 0)", kGenerators, counts}, generators.seed, kAnyWhole);
  add_number(line,
             {"--radius",
              "",
              "As many generators as leave no point farther than this, in mesh units",
              kGenerators,
              {},
              sources_but("--radius")},
             generators.radius, kPositive);
}

/// A number above 0, or percents of the diagonal.
std::optional<ErrorBound> parse_error_bound(std::string text) {
  const bool percent = text.ends_with('%');
  if (percent) text.pop_back();
  const std::optional<double> value = parse_number_in(text, kPositive);
  if (!value) return std::nullopt;
  return ErrorBound{percent ? *value / 100 : *value, percent};
}

/// Options that choose as many generators as a mesh of them needs.
void register_sizes(CommandLine& line, GeneratorOptions& generators) {
  constexpr const char* kSizes = "Sizes (instead of -n)";
  std::vector<std::string> others = sources_but("");
  add_number(line,
             {"--target-edge",
              "",
              "As many generators as give edges of this length on average, in mesh units",
              kSizes,
              {},
              others},
             generators.target_edge, kPositive);
  others.emplace_back("--target-edge");
  line.add_value({"--error",
                  "NUMBER[%]",
                  "The fewest generators whose mesh is no farther than this from the input, in mesh units or percents "
                  "of the bounding box's diagonal; takes up to 17 remeshes",
                  kSizes,
                  {},
                  others},
                 [&generators](const std::string& text) -> std::optional<std::string> {
                   generators.error = parse_error_bound(text);
                   if (generators.error) return std::nullopt;
                   return fmt::format("'{}' is no finite number above 0, nor one with a %", text);
                 });
}

/// Options that list generators.
void register_lists(CommandLine& line, GeneratorOptions& generators) {
  add_file(line,
           {"--generators",
            "FILE",
            "A list of generators: text, .csv or .json; - for standard input",
            kGenerators,
            {},
            sources_but("--generators")},
           generators.file);
  add_choice(line,
             {"--generators-format",
              "",
              "The list's format, else told from extension and content",
              kGenerators,
              {"--generators"}},
             generators.format,
             Choices<GeneratorFormat>{
                 {"text", GeneratorFormat::text}, {"csv", GeneratorFormat::csv}, {"json", GeneratorFormat::json}});
  line.add_list({"--vertices",
                 "LIST",
                 "Vertices of the input file, from 0: 3,17,99",
                 kGenerators,
                 {},
                 sources_but("--vertices"),
                 ValueKind::whole},
                [&generators](const std::vector<std::string>& lists) {
                  generators.vertices = parse_vertex_list(join(lists, ","));
                });
}

/// Options for positions and coincident generators in a list.
void register_list_rules(CommandLine& line, GeneratorOptions& generators) {
  add_number(line,
             {"--max-snap",
              "",
              "Refuse a point of --generators that is farther than this from the surface, in mesh units",
              kGenerators,
              {"--generators"}},
             generators.max_snap, kNotNegative);
  line.add_flag({"--merge-coincident",
                 "",
                 "Keep one of several generators in the same place, instead of refusing them",
                 kGenerators,
                 {"--generators", "--vertices"}},
                generators.merge_coincident);
}

void register_compute(CommandLine& line, ComputeOptions& compute) {
  add_choice(
      line,
      {"--method", "",
       "How the diagram is built: of exact distances (default), growth-based by fast marching, or by the paper's steps "
       "as written",
       kComputing},
      compute.method, Choices<Method>{{"exact", Method::exact}, {"gbgvd", Method::gbgvd}, {"paper", Method::paper}});
  add_number(line,
             {"--chord-tolerance",
              "",
              fmt::format("How far the straight pieces of an exact bisector may be from it, in mean edge lengths "
                          "(default: {}, at least {})",
                          DiagramOptions{}.chord_tolerance, kLeastChordTolerance),
              kComputing,
              {},
              {"--method gbgvd", "--method paper"}},
             compute.chord_tolerance, kPositive);
  add_choice(line,
             {"--front",
              "",
              "Front of fast marching: planar (default of --method paper), or circles (of --method gbgvd)",
              kComputing,
              {"--method gbgvd", "--method paper"}},
             compute.front, Choices<Front>{{"planar", Front::planar}, {"circle", Front::circle}});
  add_number(
      line, {"--threads", "", "Threads to use (default: all cores); the result is the same for any number", kComputing},
      compute.threads, kThreads);
  OptionText max_memory{"--max-memory", "SIZE", "End the run where it would hold more memory than this: 500M, 2G",
                        kComputing};
  max_memory.kind = ValueKind::size;
  line.add_value(max_memory, [&compute](const std::string& text) -> std::optional<std::string> {
    const ParsedSize size = parse_size(text);
    if (!size.wrong.empty()) return size.wrong;
    compute.max_memory = size.bytes;
    return std::nullopt;
  });
  line.add_flag({"--verify", "", "Measure the diagram's error against exact distances after the run", kComputing},
                compute.verify);
}

/// Options that say which files get the result.
void register_targets(CommandLine& line, OutputOptions& output, const std::vector<std::string>& formats) {
  line.add_list({"-o,--output",
                 "FILE",
                 "Write this file (." + join(formats, ", .") + "); may be repeated; - for standard output",
                 kOutput,
                 {},
                 {"--output-dir"}},
                [&output](const std::vector<std::string>& files) { output.files = files; });
  add_file(line,
           {"--output-dir",
            "DIR",
            "Run once for each INPUT, and write files named after it into this folder",
            kOutput,
            {},
            {"--output", "--report", "--diagram", "--view"}},
           output.folder, "folder");
  output.formats = {formats.front()};
  line.add_value({"--output-format",
                  join(formats, "|"),
                  "What -o - or --output-dir writes (default: " + formats.front() +
                      "); for --output-dir also several, with commas",
                  kOutput,
                  {"-o -", "--output-dir"}},
                 [&output, formats](const std::string& text) -> std::optional<std::string> {
                   output.formats.clear();
                   for (const std::string& format : split_names(text)) {
                     if (!contains(formats, format)) {
                       return fmt::format("'{}' is none of {}", format, join(formats, "|"));
                     }
                     if (contains(output.formats, format)) return fmt::format("{} is there twice; keep one", format);
                     output.formats.push_back(format);
                   }
                   return std::nullopt;
                 });
}

/// Options that only some formats have.
void register_format_options(CommandLine& line, OutputOptions& output) {
  const std::vector<std::string> targets{"--output", "--output-format", "--output-dir"};
  OptionText no_curves{"--no-curves", "", "Leave the bisectors out of .obj, .vtp and .glb", kOutput};
  no_curves.depends_on = targets;
  no_curves.idle = [&output]() -> std::optional<std::string> {
    if (writes_any(output, {"obj", "vtp", "glb"})) return std::nullopt;
    return fmt::format("only .obj, .vtp and .glb hold curves; write one of them with {} or leave --no-curves out",
                       format_option(output));
  };
  line.add_flag(no_curves, output.no_curves);
  OptionText ascii_ply{"--ascii-ply", "", "Write .ply as text, not binary: meshio reads face labels in text only",
                       kOutput};
  ascii_ply.depends_on = targets;
  ascii_ply.idle = [&output]() -> std::optional<std::string> {
    if (writes_any(output, {"ply"})) return std::nullopt;
    return fmt::format("no .ply is written; write one with {} or leave --ascii-ply out", format_option(output));
  };
  line.add_flag(ascii_ply, output.ascii_ply);
}

void register_output(CommandLine& line, OutputOptions& output, const std::vector<std::string>& formats) {
  register_targets(line, output, formats);
  register_format_options(line, output);
  add_file(line, {"--report", "FILE", "Write a report of the run (JSON)", kOutput}, output.report);
  add_file(line, {"--diagram", "FILE", "Write the diagram (JSON)", kOutput}, output.diagram);
  add_file(line, {"--view", "FILE", "Write a page that shows the result (HTML)", kOutput}, output.view);
  add_choice(line, {"--up", "", "The axis that points up on the page (default: y)", kOutput, {"--view"}}, output.up,
             Choices<UpAxis>{{"x", UpAxis::x},
                             {"y", UpAxis::y},
                             {"z", UpAxis::z},
                             {"-x", UpAxis::minus_x},
                             {"-y", UpAxis::minus_y},
                             {"-z", UpAxis::minus_z}});
}

}  // namespace

std::vector<std::int64_t> parse_vertex_list(const std::string& text) {
  std::vector<std::int64_t> indices;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t comma = std::min(text.find(',', start), text.size());
    const std::string field = trim(text.substr(start, comma - start));
    const auto index = parse_number<std::int64_t>(field);
    if (!index || *index < 0) {
      throw Error(ErrorCode::invalid_option,
                  fmt::format("--vertices: '{}' is no vertex index; write indices from 0, as in 3,17,99", field));
    }
    indices.push_back(*index);
    start = comma + 1;
  }
  return indices;
}

void register_options(CommandLine& line, Options& options, const std::vector<std::string>& output_formats, bool sizes) {
  register_input(line, options.input);
  register_sampling(line, options.generators, sizes);
  if (sizes) register_sizes(line, options.generators);
  register_lists(line, options.generators);
  register_list_rules(line, options.generators);
  register_compute(line, options.compute);
  register_output(line, options.output, output_formats);
  line.add_config({"--config", "FILE.toml", "Read options from this TOML file; the command line overrides it"},
                  options.config);
  line.add_flag({"-q,--quiet", "", "Say nothing but errors"}, options.quiet);
  line.add_flag({"-v,--verbose", "", "Say what each step took", "", {}, {"--quiet"}}, options.verbose);
}

}  // namespace gvd::app
