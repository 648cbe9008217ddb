#include "common/register_options.hpp"

#include <fmt/format.h>

#include <map>

#include "common/numbers.hpp"
#include "gvd/error.hpp"

namespace gvd::app {
namespace {

constexpr Range<std::int32_t> kThreads{1, 4096, "a whole number from 1 to 4096"};

template <class T>
using Names = std::vector<std::pair<std::string, T>>;

/// An option that takes one of a few names. `Target` is T or std::optional<T>.
template <class T, class Target>
CLI::Option* add_choice(CLI::App& cli, const std::string& name, Target& target, const Names<T>& names,
                        const std::string& description) {
  std::string listed;
  for (const auto& [text, value] : names) listed += (listed.empty() ? "" : "|") + text;
  const auto store = [&target, names, name, listed](const std::string& text) {
    for (const auto& [known, value] : names) {
      if (text == known) {
        target = value;
        return;
      }
    }
    throw CLI::ValidationError(name, fmt::format("'{}' is none of {}", text, listed));
  };
  return cli.add_option_function<std::string>(name, store, description)->type_name(listed);
}

Names<std::string> self_named(const std::vector<std::string>& names) {
  Names<std::string> pairs;
  for (const std::string& name : names) pairs.emplace_back(name, name);
  return pairs;
}

void register_input(CLI::App& cli, InputOptions& input) {
  cli.add_option("INPUT", input.path, "The mesh: .obj, .ply, .off or .stl; - for standard input")
      ->type_name("")
      ->required();
  add_choice(cli, "--input-format", input.format, self_named({"obj", "ply", "off", "stl"}),
             "The input's format; needed with -, else told from content and extension")
      ->group("Input");
  add_choice(cli, "--on-defect", input.on_defect, self_named({"error", "repair", "largest"}),
             "What to do about defects of the mesh: refuse, repair what loses nothing (default), or repair and keep "
             "the largest component")
      ->group("Input");
}

void register_generators(CLI::App& cli, GeneratorOptions& generators) {
  const std::string group = "Generators (exactly one of -n, --generators, --vertices, --radius)";
  add_number<std::int32_t>(cli, "-n,--count", generators.count, kCount, "Choose N generators")->group(group);
  add_choice(
      cli, "--sampling", generators.sampling,
      Names<SamplingKind>{
          {"farthest", SamplingKind::farthest}, {"random", SamplingKind::random}, {"poisson", SamplingKind::poisson}},
      "How -n chooses (default: farthest)")
      ->needs(cli.get_option("-n"))
      ->group(group);
  add_number<std::uint64_t>(cli, "--seed", generators.seed, kAnyWhole, "Seed of the choice (default: 0)")->group(group);
  cli.add_option("--generators", generators.file,
                 "A list of generators: text, .csv or .json; see docs/guide/generators.md")
      ->type_name("FILE")
      ->group(group);
  const auto store_vertices = [&generators](const std::vector<std::string>& lists) {
    generators.vertices = parse_vertex_list(CLI::detail::join(lists, ","));
  };
  cli.add_option_function<std::vector<std::string>>("--vertices", store_vertices,
                                                    "Vertices of the input file, from 0: 3,17,99")
      ->type_name("LIST")
      ->allow_extra_args(false)
      ->group(group);
  add_number<double>(cli, "--radius", generators.radius, kPositive,
                     "As many generators as leave no point farther than this, in mesh units")
      ->group(group);
  add_number<double>(cli, "--max-snap", generators.max_snap, kNotNegative,
                     "Refuse a point of --generators that is farther than this from the surface, in mesh units")
      ->needs(cli.get_option("--generators"))
      ->group(group);
  cli.add_flag("--merge-coincident", generators.merge_coincident,
               "Keep one of several generators in the same place, instead of refusing them")
      ->group(group);
}

void register_compute(CLI::App& cli, ComputeOptions& compute) {
  add_choice(cli, "--method", compute.method, Names<Method>{{"exact", Method::exact}, {"gbgvd", Method::gbgvd}},
             "How the diagram is built: of exact distances (default), or growth-based by fast marching")
      ->group("Computing");
  add_number<double>(
      cli, "--chord-tolerance", compute.chord_tolerance, kPositive,
      fmt::format("How far the straight pieces of an exact bisector may be from it, in mean edge lengths "
                  "(default: {}, at least {})",
                  DiagramOptions{}.chord_tolerance, kLeastChordTolerance))
      ->group("Computing");
  add_choice(cli, "--front", compute.front, Names<Front>{{"planar", Front::planar}, {"circle", Front::circle}},
             "Wavefront of --method gbgvd: the paper's planar one, or circles (default)")
      ->group("Computing");
  add_number<std::int32_t>(cli, "--threads", compute.threads, kThreads,
                           "Threads to use (default: all cores); the result is the same for any number")
      ->group("Computing");
  cli.add_flag("--verify", compute.verify, "Measure the diagram's error against exact distances after the run")
      ->group("Computing");
}

void register_output(CLI::App& cli, OutputOptions& output, const std::vector<std::string>& formats) {
  const std::string listed = fmt::format("{}", fmt::join(formats, ", ."));
  cli.add_option("-o,--output", output.files,
                 fmt::format("Write this file (.{}); may be repeated; - for standard output", listed))
      ->type_name("FILE")
      ->allow_extra_args(false)
      ->group("Output");
  output.stdout_format = formats.front();
  add_choice(cli, "--output-format", output.stdout_format, self_named(formats),
             fmt::format("What -o - writes (default: {})", formats.front()))
      ->group("Output");
  cli.add_option("--report", output.report, "Write a report of the run (JSON)")->type_name("FILE")->group("Output");
  cli.add_option("--diagram", output.diagram, "Write the diagram (JSON)")->type_name("FILE")->group("Output");
  cli.add_option("--view", output.view, "Write a page that shows the result (HTML)")
      ->type_name("FILE")
      ->group("Output");
}

}  // namespace

std::vector<std::int64_t> parse_vertex_list(const std::string& text) {
  std::vector<std::int64_t> indices;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t comma = std::min(text.find(',', start), text.size());
    const std::string part = CLI::detail::trim_copy(text.substr(start, comma - start));
    const auto index = parse_number<std::int64_t>(part);
    if (!index || *index < 0) {
      throw Error(ErrorCode::invalid_option,
                  fmt::format("--vertices: '{}' is no vertex index; write indices from 0, as in 3,17,99", part));
    }
    indices.push_back(*index);
    start = comma + 1;
  }
  return indices;
}

void register_options(CLI::App& cli, Options& options, const std::vector<std::string>& output_formats) {
  register_input(cli, options.input);
  register_generators(cli, options.generators);
  register_compute(cli, options.compute);
  register_output(cli, options.output, output_formats);
  cli.set_config("--config", "", "Read options from this TOML file; the command line goes before it")
      ->type_name("FILE.toml");
  cli.allow_config_extras(CLI::config_extras_mode::error);
  cli.add_flag("-q,--quiet", options.quiet, "Say nothing but errors");
  cli.add_flag("-v,--verbose", options.verbose, "Say what each step took");
}

}  // namespace gvd::app
