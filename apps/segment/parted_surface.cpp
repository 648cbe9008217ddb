// The regions that gvd-segment keeps to. A diagram on the separated mesh respects them by itself, and all of its files
// have the input's faces; only their vertices are copied on borders, and copies are left out of files.
//
// Each level but the last labels whole faces, and its labels are the regions of the next one. Given regions are the
// first level's; a mask takes faces out of them, or out of the whole surface.

#include "segment/parted_surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "common/options/typed_options.hpp"
#include "common/run_parts.hpp"
#include "gvd/error.hpp"
#include "gvd/text.hpp"

namespace gvd::app {
namespace {

using Json = nlohmann::ordered_json;

/// Stores "10,100" as numbers of generators that ascend.
std::string parse_levels(const std::string& text, std::vector<std::int32_t>& levels) {
  for (const std::string& field : CLI::detail::split(text, ',')) {
    const auto count = parse_number_in(CLI::detail::trim_copy(field), kCount);
    if (!count) return fmt::format("'{}' is not {}", printable(field), kCount.text);
    if (!levels.empty() && *count <= levels.back()) {
      return fmt::format("{} follows {}; write ascending numbers, as in 10,100,1000", *count, levels.back());
    }
    levels.push_back(*count);
  }
  return "";
}

}  // namespace

void add_region_options(CLI::App& app, RegionOptions& regions, GeneratorOptions& generators) {
  add_region_files(app, regions, "regions and distances");
  // The number of generators is set, too, as by -n: the rest of the command knows no other one.
  const auto store_count = [&](const std::string& text) -> std::string {
    regions.per_region = generators.count = parse_number_in(text, kCount);
    return generators.count ? "" : fmt::format("'{}' is not {}", printable(text), kCount.text);
  };
  add_parsed(app, "--per-region", "N", store_count, "Number of generators to sample in each region of --within")
      ->needs("--within")
      ->excludes("--count", "--radius", "--generators", "--vertices");
  const auto store_levels = [&](const std::string& text) {
    std::string wrong = parse_levels(text, regions.levels);
    if (wrong.empty()) generators.count = regions.levels.back();
    return wrong;
  };
  add_parsed(app, "--levels", "LIST", store_levels,
             "Segment several times, each inside the regions of the time before: the numbers of generators, as in "
             "10,100,1000; --cut cuts along those of the last level")
      ->expected(1, CLI::detail::expected_max_vector_size)
      ->excludes("--count", "--radius", "--generators", "--vertices", "--per-region");
}

void report_region_options(Run& run, const RegionOptions& options) {
  Json& reported = run.report().options();
  reported["within"] = or_null(options.within);
  reported["mask"] = or_null(options.mask);
  reported["per_region"] = or_null(options.per_region);
  reported["levels"] = options.levels.empty() ? Json() : Json(options.levels);
  if (options.per_region || !options.levels.empty()) reported["n"] = nullptr;
}

PartedSurface::PartedSurface(Run& run, const CheckedMesh& input, const RegionOptions& options,
                             const SegmentOptions& labels)
    : input_(input), options_(options) {
  if (options.are_given()) {
    GivenRegions found = run.timed("regions", [&] { return read_regions(run, input, options); });
    if (!found.given.empty()) numbers_.push_back({kRegionName, std::move(found.given)});
    regions_ = std::move(found.regions);
  }
  label_levels(run, labels);
  if (is_parted()) separated_ = run.timed("separate", [&] { return separate_regions(input_.mesh, regions_); });
}

// A level needs no report of its own: a run of gvd-segment with its number of generators has the same figures.
void PartedSurface::label_levels(Run& run, const SegmentOptions& labels) {
  LevelOptions level;
  level.generators.sampling = make_sampling_options(run);
  level.diagram = make_diagram_options(run.options().compute);
  level.diagram.progress = run.progress();
  level.labels = labels;
  for (std::size_t i = 0; i + 1 < options_.levels.size(); ++i) {
    level.generators.sampling.count = options_.levels[i];
    const std::string name = level_name(i + 1);
    const auto found = run.timed(name, [&] { return label_level(input_.mesh, regions_, level); });
    regions_ = to_regions(found);
    numbers_.push_back({name, regions_});
  }
}

// Listed points are resolved on the input, which may see a point on a border from any face beside it; so these are
// moved into a region, and reported again with the faces that count.
std::vector<SurfacePoint> PartedSurface::make_generators(Run& run) const {
  if (!is_parted()) return app::make_generators(run, input_);
  const std::set<std::int32_t> numbers(regions_.begin(), regions_.end());
  run.report().results()["within"] = {
      {"regions", std::ranges::count_if(numbers, [](std::int32_t region) { return region >= 0; })},
      {"left_out_faces", std::ranges::count_if(regions_, [](std::int32_t region) { return region < 0; })}};
  const Sampler sampler = [&](const Mesh&, const SamplingOptions& options) {
    RegionSamples samples = sample_regions(separated_, regions_, {options, options_.per_region.has_value()});
    note_samples(run, samples);
    return std::move(samples.points);
  };
  std::vector<SurfacePoint> points = app::make_generators(run, input_, sampler);
  if (!run.options().generators.are_listed()) return points;
  move_into_regions(input_.mesh, regions_, points);
  run.report().set_generators(input_.mesh, points);
  return points;
}

std::vector<std::vector<Vec3>> PartedSurface::borders() const {
  std::vector<std::vector<Vec3>> borders;
  const Mesh& mesh = input_.mesh;
  if (!is_parted()) return borders;
  for (const EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e), twin = mesh.twin(h);
    if (!twin.valid() || regions_[Mesh::face(h)] == regions_[Mesh::face(twin)]) continue;
    borders.push_back({mesh.position(mesh.from(h)), mesh.position(mesh.to(h))});
  }
  return borders;
}

void PartedSurface::note_samples(Run& run, const RegionSamples& samples) const {
  Json& results = run.report().results()["within"];
  results["parts"] = samples.parts;
  results["parts_without_generator"] = samples.empty_parts;
  const std::int64_t left_out = results["left_out_faces"];
  run.console().note(
      fmt::format("inside {} of {}{}", counted(samples.regions, "region", "regions"),
                  counted(samples.parts, "connected part", "connected parts"),
                  left_out == 0 ? "" : fmt::format("; {} left out", counted(left_out, "face is", "faces are"))));
  if (samples.empty_parts == 0) return;
  const bool each = options_.per_region.has_value();
  run.console().note(fmt::format("{} no generator, because there are too few; {}",
                                 counted(samples.empty_parts, "part of a region has", "parts of regions have"),
                                 each ? "raise --per-region" : fmt::format("{} reach all", samples.parts)));
}

const Diagram& PartedSurface::restrict(const Diagram& diagram, Diagram& restricted) const {
  return is_parted() ? restricted = restrict_to_input(separated_, diagram) : diagram;
}

void PartedSurface::add_labels(const IdVector<FaceId, GeneratorId>& labels, std::vector<FaceNumbers>& numbers) const {
  if (!options_.levels.empty()) numbers.push_back({level_name(options_.levels.size()), to_regions(labels)});
}

std::vector<FaceNumbers> levels_of(const std::vector<FaceNumbers>& numbers) {
  std::vector<FaceNumbers> levels;
  std::ranges::copy_if(numbers, std::back_inserter(levels), [](const FaceNumbers& n) { return n.name != kRegionName; });
  return levels;
}

}  // namespace gvd::app
