// The regions that gvd-segment keeps to. A diagram on the separated mesh respects them by itself, and all of its files
// have the input's faces; only their vertices are copied on borders, and copies are left out of files.
//
// Each level but the last labels whole faces, and its labels are the regions of the next one. Given regions are the
// first level's; a mask takes faces out of them, or out of the whole surface.

#include "segment/parted_surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "common/run_observer.hpp"
#include "common/run_parts.hpp"
#include "gvd/error.hpp"
#include "gvd/text.hpp"

namespace gvd::app {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

void describe(OptionList& list, RegionOptions& options) {
  describe(list, options, "regions and distances");
  list.option("per_region", Number{&options.per_region, {.least = 1}},
              {.help = "Number of generators to sample in each region of {option:within}"});
  list.option(
      "levels", Counts{&options.levels},
      {.help = "Segment several times, each inside the regions of the time before",
       .more = ": the numbers of generators, as in 10,100,1000; {option:cut} cuts along those of the last level"});
  list.needs("per_region", "within");
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
  RunObserver observer(run);
  level.generators.sampling = make_sampling_options(run.options().generators, run.options().compute.diagram, observer);
  level.generators.sampling.progress = run.progress();
  level.diagram = run.options().compute.diagram;
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
