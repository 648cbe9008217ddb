// Diagrams inside regions: the regions as given, generators inside them, and figures.

#include "gvd/parted_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>
#include <utility>

#include "gvd/text.hpp"

namespace gvd {
namespace {

void tell_samples(Observer& observer, const PartedMesh& parted, bool each) {
  const RegionSamples& samples = parted.samples;
  const auto left_out = std::ranges::count_if(parted.regions, [](std::int32_t region) { return region < 0; });
  observer.note(
      fmt::format("inside {} of {}{}", counted(samples.regions, "region", "regions"),
                  counted(samples.parts, "connected part", "connected parts"),
                  left_out == 0 ? "" : fmt::format("; {} left out", counted(left_out, "face is", "faces are"))));
  if (samples.empty_parts == 0) return;
  observer.note(fmt::format("{} no generator, because there are too few; {}",
                            counted(samples.empty_parts, "part of a region has", "parts of regions have"),
                            each ? "raise \1per_region\2" : fmt::format("{} reach all", samples.parts)));
}

}  // namespace

std::shared_ptr<const Diagram> PartedMesh::on_input(std::shared_ptr<const Diagram> diagram) const {
  if (!is_parted()) return diagram;
  return std::make_shared<const Diagram>(restrict_to_input(separated, *diagram));
}

SeparatedDiagram keep_separated(const PartedMesh& parted, std::shared_ptr<const Diagram> diagram) {
  if (!parted.is_parted() && parted.levels == 0) return {};
  return {std::make_shared<PartedMesh>(parted), std::move(diagram)};
}

PartedMesh find_parted(const CheckedMesh& input, const GivenRegions& given, Observer& observer) {
  PartedMesh parted;
  if (!given.are_given()) return parted;
  FoundRegions found = as_step(observer, "regions", [&] { return find_regions(input, given, observer); });
  if (!found.given.empty()) parted.numbers.push_back({kRegionName, std::move(found.given)});
  parted.regions = std::move(found.regions);
  return parted;
}

void separate(const Mesh& input, PartedMesh& parted, Observer& observer) {
  if (!parted.is_parted()) return;
  parted.separated = as_step(observer, "separate", [&] { return separate_regions(input, parted.regions); });
}

std::vector<SurfacePoint> sample_inside(PartedMesh& parted, const SamplingOptions& sampling, bool each,
                                        Observer& observer) {
  parted.samples = sample_regions(parted.separated, parted.regions, {sampling, each});
  tell_samples(observer, parted, each);
  return std::exchange(parted.samples.points, {});
}

// Listed points are resolved on the input, which may see a point on a border from any face beside it; so these are
// moved into a region.
ResolvedGenerators choose_inside(const CheckedMesh& input, PartedMesh& parted, const GeneratorOptions& asked,
                                 const DiagramOptions& diagram, bool each, Observer& observer) {
  if (!parted.is_parted() || asked.are_listed()) {
    ResolvedGenerators found = choose_generators(input, asked, diagram, observer);
    if (parted.is_parted()) move_into_regions(input.mesh, parted.regions, found.points);
    return found;
  }
  const Step step(observer, "generators");
  ResolvedGenerators found;
  found.points = sample_inside(parted, make_sampling_options(asked, diagram, observer), each, observer);
  observer.detail(counted(std::ssize(found.points), "generator", "generators"));
  return found;
}

void visit_parted(ObjectVisitor& visitor, const PartedMesh& parted) {
  const std::set<std::int32_t> numbers(parted.regions.begin(), parted.regions.end());
  const auto is_region = [](std::int32_t region) { return region >= 0; };
  const auto figure = [&](const Meaning& meaning, std::int64_t value) {
    visitor.figure(meaning, parted.is_parted() ? Figure(value) : Figure());
  };
  figure({"within.regions", "", "that the cells keep to"}, std::ranges::count_if(numbers, is_region));
  figure({"within.left_out_faces", "", "in no region"},
         std::ssize(parted.regions.raw()) - std::ranges::count_if(parted.regions, is_region));
  const RegionSamples& samples = parted.samples;
  const auto sampled = [&](std::int64_t value) { return samples.regions > 0 ? Figure(value) : Figure(); };
  visitor.figure({"within.parts", "", "connected parts of regions, where generators are sampled"},
                 sampled(samples.parts));
  visitor.figure({"within.parts_without_generator", "", "of these"}, sampled(samples.empty_parts));
}

}  // namespace gvd
