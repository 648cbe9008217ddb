// The options that the commands share: their names, their targets, and which of them go together. Exactly one option
// says where the generators come from, so that each of them excludes the others, and an option that only works beside
// some of them excludes the rest. What depends on values is in the rules at the end.

#include "common/options/register_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "common/options/completion.hpp"
#include "common/options/typed_options.hpp"
#include "gvd/constrained_start.hpp"

namespace gvd::app {
namespace {

using Formats = std::vector<std::string>;

constexpr Range<std::int32_t> kThreads{1, 4096, "a whole number from 1 to 4096"};
constexpr Range<double> kAngle{std::numeric_limits<double>::min(), 180, "above 0 and at most 180"};
constexpr Range<std::int64_t> kCoarseFaces{4, 1000000000, "a whole number from 4 to 1000000000 or 'off'"};
constexpr Range<double> kGradation{std::numeric_limits<double>::min(), std::numeric_limits<double>::max(), "above 0"};

/// "true" and "false" are those of a TOML file. The command line writes --weld without a number as 0.
void register_weld(CLI::App& app, InputOptions& input) {
  const auto store = [&input](const std::string& text) -> std::string {
    const std::optional<double> tolerance = text == "true" ? 0 : parse_number_in(text, kNotNegative);
    input.weld = tolerance;
    const bool is_known = tolerance || text == "false";
    return is_known ? "" : fmt::format("'{}' is not {}", printable(text), kNotNegative.text);
  };
  add_parsed(app, kWeldOption, "[NUMBER]", store,
             "Join vertices at the same place, as in an STL, and with a number also those at most so many mesh units "
             "apart");
}

void register_input(CLI::App& app, InputOptions& input) {
  app.option_defaults()->group("Input");
  const auto store = [&input](const std::vector<std::string>& paths) {
    input.paths = paths;
    input.path = paths.front();
  };
  app.add_option_function<std::vector<std::string>>("INPUT", store,
                                                    "The mesh (.obj, .ply, .off, .stl, .vtp, .vtu, .vtk, .glb, .gltf, "
                                                    ".gii, MNI's, FreeSurfer's, also .gz), or - for "
                                                    "standard input; several need --output-dir")
      ->required()
      ->type_name("")
      ->check(not_empty("file"));
  add_choice(app, "--input-format", input.format, kMeshFormatNames,
             "Format of the input; required with -, otherwise detected from content and extension");
  add_choice(app, "--on-defect", input.on_defect, kDefectPolicyNames,
             "How to treat defects of the mesh: refuse them, repair them without loss (default), or repair them and "
             "keep only the largest component");
  register_weld(app, input);
}

/// Options that choose generators on the surface.
void register_sampling(CLI::App& app, GeneratorOptions& generators) {
  add_number(app, "-n,--count", generators.count, kCount, "Number of generators to sample");
  add_choice(app, "--sampling", generators.sampling, kSamplingNames, "How -n places generators (default: farthest)");
  add_number(app, "--seed", generators.seed, kAnyWhole, "Seed of the random choices (default: 0)");
  add_number(app, "--radius", generators.radius, kPositive,
             "Sample generators until no point of the surface is farther than this from the nearest one, in mesh units")
      ->excludes("--count", "--sampling");
}

/// Reads "3,17,99" as indices and appends them. Returns what is wrong with the text; empty where nothing is.
std::string append_vertices(const std::string& text, std::vector<std::int64_t>& indices) {
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t comma = std::min(text.find(',', start), text.size());
    const std::string field = CLI::detail::trim_copy(text.substr(start, comma - start));
    const auto index = parse_number<std::int64_t>(field);
    if (!index || *index < 0) {
      return fmt::format("'{}' is not a vertex index; write indices from 0, as in 3,17,99", field);
    }
    indices.push_back(*index);
    start = comma + 1;
  }
  return "";
}

void register_lists(CLI::App& app, GeneratorOptions& generators) {
  add_file(app, "--generators", generators.file,
           "File that lists the generators (text, .csv, .json, .ply or .xyz), or - for standard input")
      ->excludes("--count", "--radius", "--sampling", "--seed");
  add_choice(app, "--generators-format", generators.format, kGeneratorFormatNames,
             "Format of that list, otherwise detected from extension and content")
      ->needs("--generators");
  const auto store = [&generators](const std::string& text) {
    if (!generators.vertices) generators.vertices.emplace();
    return append_vertices(text, *generators.vertices);
  };
  add_parsed(app, "--vertices", "LIST", store, "Use these vertices of the input file, counted from 0, as in 3,17,99")
      ->expected(1, CLI::detail::expected_max_vector_size)
      ->excludes("--count", "--radius", "--generators", "--sampling", "--seed");
  add_number(app, "--max-snap", generators.max_snap, kNotNegative,
             "Refuse a point of --generators that is farther than this from the surface, in mesh units")
      ->excludes("--count", "--radius", "--vertices");
  add_flag(app, "--merge-coincident", generators.merge_coincident,
           "Merge generators that are in the same place instead of refusing them")
      ->excludes("--count", "--radius");
}

/// Stores "3,17" as vertices, anything else as the name of a file.
void add_list(CLI::App& app, GeneratorOptions& list, const std::string& name, const std::string& description) {
  list.names = {name, name, name};
  const auto store = [&list](const std::string& text) -> std::string {
    const bool is_file = text.find_first_not_of("0123456789, ") != text.npos;
    if (text.empty()) return "the list is empty; write vertices, as in 3,17,99, or name a file";
    if (!list.file.empty() || (is_file && list.vertices)) {
      return fmt::format("'{}': give vertices or one file", printable(text));
    }
    if (!is_file && !list.vertices) list.vertices.emplace();
    if (!is_file) return append_vertices(text, *list.vertices);
    list.file = text;
    return "";
  };
  add_parsed(app, name, "LIST", store, description)->expected(1, CLI::detail::expected_max_vector_size);
}

void register_points(CLI::App& app, Options& options) {
  GeneratorOptions& sources = options.generators;
  add_list(
      app, sources, "--from",
      "The points to measure from: vertices of the input file, counted from 0, as in 3,17,99, or a file that lists "
      "points (text, .csv or .json), or - for standard input");
  add_list(app, options.targets, "--to", "The points to measure to, as --from gives them (default: all vertices)");
  add_number(app, "--max-snap", sources.max_snap, kNotNegative,
             "Refuse a point of a list that is farther than this from the surface, in mesh units");
  add_flag(app, "--merge-coincident", sources.merge_coincident,
           "Merge points of --from that are in the same place instead of refusing them");
}

void register_method(CLI::App& app, ComputeOptions& compute) {
  add_choice(app, "--method", compute.method, kMethodNames,
             "How to build the diagram: from exact distances (default), by growth with fast marching, or by the "
             "paper's steps as written");
  add_number(app, "--chord-tolerance", compute.chord_tolerance, kPositive,
             fmt::format("Largest distance between an exact bisector and its straight pieces, in mean edge lengths "
                         "(default: {}, at least {})",
                         DiagramOptions{}.chord_tolerance, kLeastChordTolerance));
  add_choice(app, "--front", compute.front, kFrontNames,
             "Shape of the front in fast marching: planar (default with --method paper) or circle (default with "
             "--method gbgvd)");
}

void register_resources(CLI::App& app, ComputeOptions& compute) {
  add_number(app, "--threads", compute.threads, kThreads,
             "Number of threads (default: all cores); it does not change the result");
  const auto store = [&compute](const std::string& text) { return parse_size(text, compute.max_memory); };
  add_parsed(app, "--max-memory", "SIZE", store, "End the run if it needs more memory than this, as in 500M or 2G");
}

void register_verify(CLI::App& app, ComputeOptions& compute) {
  add_flag(app, "--verify", compute.verify, "After the run, measure the error of the diagram against exact distances");
}

/// "=" parts a name with two dashes from its value, but "-o=a.ply" is the value "=a.ply".
std::string check_equals_sign(const std::string& file) {
  if (!file.starts_with('=')) return "";
  return fmt::format("'{}' begins with =; write -o {}", printable(file), printable(file.substr(1)));
}

/// --view names a page, or with --output-dir asks for one for each input, without a name.
void register_view(CLI::App& app, OutputOptions& output) {
  const auto store = [&output](const std::string& file) {
    output.view = file;
    output.views = file.empty();
  };
  app.add_option_function<std::string>("--view", store,
                                       "Write an interactive page of the result (HTML); with --output-dir, --view "
                                       "takes no name, and each INPUT has a page named after it")
      ->expected(0, 1)
      ->type_name("FILE.html")
      ->check(has_side_extension("--view"));
  add_flag(app, "--open", output.open,
           "Show the page in the browser ($BROWSER, or else the system's); without --view, it is INPUT.gvd.html in the "
           "current folder")
      ->excludes("--output-dir");
  add_choice(app, "--up", output.up, kUpAxisNames, "Axis that points up on the page (default: y)");
}

void register_output(CLI::App& app, OutputOptions& output, const Formats& formats) {
  app.add_option("-o,--output", output.files,
                 "File to write, with an extension of --output-format; or - for standard output. May be repeated")
      ->allow_extra_args(false)
      ->type_name("FILE")
      ->check(check_equals_sign);
  app.add_option("--output-dir", output.folder,
                 "Process each INPUT in turn, and write files named after it to this folder")
      ->type_name("DIR")
      ->check(not_empty("folder"))
      ->excludes("--output");
  output.formats = {formats.front()};
  app.add_option(
         "--output-format", output.formats,
         fmt::format("Format of -o - or --output-dir (default: {}); --output-dir takes several, separated by commas. "
                     "With fs, -o takes any name, such as lh.white",
                     formats.front()))
      ->allow_extra_args(false)
      ->delimiter(',')
      ->type_name(fmt::format("{}", fmt::join(formats, "|")))
      ->check([formats](const std::string& format) {
        return contains(formats, format) ? "" : describe_unknown(format, formats);
      });
  add_flag(app, "--ascii-ply", output.ascii_ply,
           "Write .ply as text instead of binary; meshio reads the labels of faces from text, and from .vtu");
  add_side_output(app, "--report", output.report, "Write a report of the run (JSON)")->excludes("--output-dir");
  register_view(app, output);
  add_side_output(app, "--summary", output.summary, "Write a table with a row for each INPUT (CSV)")
      ->needs("--output-dir");
}

void register_diagram_output(CLI::App& app, OutputOptions& output) {
  add_flag(app, "--no-curves", output.no_curves, "Leave the bisectors out of .obj, .vtp, .vtu and .glb");
  add_side_output(app, "--diagram", output.diagram, "Write the diagram (JSON)")->excludes("--output-dir");
}

/// Why an option for some formats does nothing, unless a file or standard output gets one of them.
std::string why_unused(const OutputOptions& output, const Formats& wanted, const std::string& reason) {
  for (const std::string& format : written_formats(output)) {
    if (contains(wanted, format)) return "";
  }
  const bool names_formats = !output.folder.empty() || contains(output.files, "-");
  return fmt::format(fmt::runtime(reason), names_formats ? "--output-format" : "-o");
}

std::vector<ValueRule> method_rules(CLI::App& app, ComputeOptions& compute) {
  CLI::Option *const method = app.get_option("--method"), *const chord = app.get_option("--chord-tolerance");
  const auto clash = [&compute]() -> std::string {
    if (!compute.chord_tolerance || compute.method == Method::exact) return "";
    return fmt::format("--method {} and --chord-tolerance exclude each other: keep one",
                       name_in(kMethodNames, compute.method));
  };
  const auto frontless = [&compute]() -> std::string {
    if (compute.method != Method::exact) return "";
    return "--front does nothing here: add --method gbgvd or --method paper, or leave --front out";
  };
  return {{method, {chord}, clash, [&compute] { compute.method = Method::exact; }},
          {chord, {method}, clash, [&compute] { compute.chord_tolerance.reset(); }},
          {app.get_option("--front"), {method, chord}, frontless, [&compute] { compute.front.reset(); }}};
}

std::vector<CLI::Option*> find_targets(CLI::App& app) {
  return {app.get_option("--output"), app.get_option("--output-dir"), app.get_option("--output-format")};
}

ValueRule curves_rule(CLI::App& app, OutputOptions& output) {
  const auto no_curves = [&output] {
    return why_unused(output, {"obj", "vtp", "vtu", "glb"},
                      "--no-curves: only .obj, .vtp, .vtu and .glb hold curves; write one of them with {} or leave "
                      "--no-curves out");
  };
  return {app.get_option("--no-curves"), find_targets(app), no_curves, [&output] { output.no_curves = false; }};
}

std::vector<ValueRule> output_rules(CLI::App& app, OutputOptions& output) {
  const auto at = [&app](const char* name) { return app.get_option(name); };
  const auto no_format = [&output]() -> std::string {
    const auto is_chosen = [&](const std::string& file) {
      return file == "-" || format_of(output, file) == kFreeSurfer;
    };
    if (!output.folder.empty() || std::any_of(output.files.begin(), output.files.end(), is_chosen)) return "";
    if (output.prints && !names_file(output)) return "";
    return "--output-format does nothing here: add -o - or --output-dir, or leave --output-format out";
  };
  const auto no_ply = [&output] {
    return why_unused(output, {"ply"}, "--ascii-ply: no .ply is written; write one with {} or leave --ascii-ply out");
  };
  const auto no_page = [&output]() -> std::string {
    return output.view.empty() && !output.views && !output.open ? "--up requires --view or --open" : "";
  };
  const std::vector<CLI::Option*> targets = find_targets(app);
  const auto reset_formats = [&output, formats = output.formats] { output.formats = formats; };
  return {{at("--output-format"), {targets[0], targets[1]}, no_format, reset_formats},
          {at("--ascii-ply"), targets, no_ply, [&output] { output.ascii_ply = false; }},
          {at("--up"), {at("--view"), at("--open")}, no_page, [&output] { output.up.reset(); }}};
}

void register_features(CLI::App& app, ConstraintOptions& constraints) {
  const auto store = [&constraints](const std::string& text) {
    const std::optional<double> angle = parse_number_in(text, kAngle);
    constraints.features = angle;
    constraints.auto_features = text == "auto";
    const bool is_known = angle || text == "auto" || text == "none";
    return is_known ? "" : fmt::format("'{}' is not {}, 'auto' or 'none'", text, kAngle.text);
  };
  add_parsed(app, "--features", "auto|none|ANGLE", store,
             fmt::format("Put generators on corners and creases first and keep them there; a crease is an edge between "
                         "faces whose normals differ by more than this many degrees; 'auto': by more than {} degrees, "
                         "where at most half of the sampled generators suffice for creases and boundary (default: {})",
                         kUsualCreaseAngle, constraints.auto_features ? "auto" : "none"));
}

}  // namespace

std::vector<ValueRule> register_options(CLI::App& app, Options& options, const Formats& formats) {
  app.set_help_flag();
  register_input(app, options.input);
  app.option_defaults()->group("Generators (one of -n, --generators, --vertices, --radius)");
  register_sampling(app, options.generators);
  register_lists(app, options.generators);
  app.option_defaults()->group("Computing");
  register_method(app, options.compute);
  register_resources(app, options.compute);
  register_verify(app, options.compute);
  app.option_defaults()->group("Output");
  register_output(app, options.output, formats);
  register_diagram_output(app, options.output);
  std::vector<ValueRule> rules = method_rules(app, options.compute), others = output_rules(app, options.output);
  rules.insert(rules.end(), others.begin(), others.end());
  rules.push_back(curves_rule(app, options.output));
  return rules;
}

std::vector<ValueRule> register_distance_options(CLI::App& app, Options& options, const Formats& formats) {
  options.has_diagram = false;
  app.set_help_flag();
  register_input(app, options.input);
  app.option_defaults()->group("Points");
  register_points(app, options);
  app.option_defaults()->group("Computing");
  register_resources(app, options.compute);
  app.option_defaults()->group("Output");
  register_output(app, options.output, formats);
  return output_rules(app, options.output);
}

void register_constraints(CLI::App& app, ConstraintOptions& constraints) {
  app.option_defaults()->group("Constraints");
  add_file(app, "--fixed", constraints.fixed, "File that lists generators to keep in place; -n includes them");
  register_features(app, constraints);
  add_flag(app, "--keep-boundary", constraints.keep_boundary,
           "Put generators on the boundary first and keep them there");
  app.add_option("--density", constraints.density,
                 "Weight of the surface, above 0, which makes cells smaller where it is larger: 'curvature', a file "
                 "with a number for each vertex or each face (text, .npy, .shape.gii or FreeSurfer's), or the name of "
                 "a property of a PLY, VTP or VTU input")
      ->type_name("curvature|FILE|PROPERTY");
  add_number(
      app, "--gradation", constraints.gradation, kGradation,
      fmt::format("With --density curvature, how fast the size of cells may change along the surface (default: {})",
                  constraints.gradation));
}

void register_coarse(CLI::App& app, ConstraintOptions& constraints) {
  const auto store = [&constraints](const std::string& text) {
    const std::optional<std::int64_t> faces = text == "off" ? 0 : parse_number_in(text, kCoarseFaces);
    if (faces) constraints.coarse = faces;
    return faces ? "" : fmt::format("'{}' is not {}", text, kCoarseFaces.text);
  };
  add_parsed(
      app, "--coarse", "FACES|off", store,
      "Sample and relax on a decimated copy of about so many faces first (default: where the mesh is large enough)");
}

void register_general(CLI::App& app, Options& options, const std::string& version) {
  app.option_defaults()->group("General");
  const auto show_short = [] { throw CLI::CallForHelp(); };
  const auto show_all = [] { throw CLI::CallForAllHelp(); };
  app.add_flag_callback("-h", show_short, "Show the main options")->configurable(false)->trigger_on_parse();
  app.add_flag_callback("--help", show_all, "Show all options")->configurable(false)->trigger_on_parse();
  app.set_version_flag("--version", version, "Show the version")->trigger_on_parse();
  const std::vector<std::string> shells{"bash", "zsh", "fish"};
  const auto print_completion = [&app, shells](const std::string& shell) -> std::string {
    if (!contains(shells, shell)) return describe_unknown(shell, shells);
    throw CLI::CallForVersion(make_completion(app, shell), 0);  // as an answer on standard output
  };
  add_parsed(app, "--print-completion", "SHELL", print_completion, "")
      ->group("")  // hidden
      ->configurable(false)
      ->trigger_on_parse();
  app.set_config("--config", "", "Read options from this TOML file; the command line overrides it")
      ->type_name("FILE.toml")
      ->check(CLI::Validator(CLI::ExistingFile).description(""))
      ->each([&options](const std::string& file) { options.config = file; });
  add_flag(app, "-q,--quiet", options.quiet, "Print errors only");
  add_flag(app, "-v,--verbose", options.verbose, "Print details and the time of each step")->excludes("--quiet");
}

}  // namespace gvd::app
