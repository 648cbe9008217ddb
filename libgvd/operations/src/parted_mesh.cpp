// Steps of diagrams and distances inside regions: finds the given regions, places points and chooses generators inside
// them, and visits figures.

#include "gvd/parted_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>
#include <utility>

#include "figures.hpp"
#include "gvd/text.hpp"

namespace gvd {
namespace {

void tell_samples(Observer& observer, const PartedMesh& parted, bool each) {
  const RegionSamples& samples = parted.samples;
  observer.note(fmt::format("inside {} of {}{}", counted(samples.regions, "region", "regions"),
                            counted(samples.parts, "connected part", "connected parts"), describe_left_out(parted)));
  if (samples.empty_parts == 0) return;
  observer.note(fmt::format("{} no generator, because there are too few; {}",
                            counted(samples.empty_parts, "part of a region has", "parts of regions have"),
                            each ? "raise \1per_region\2" : fmt::format("{} reach all", samples.parts)));
}

}  // namespace

std::int64_t PartedMesh::count_regions() const {
  const std::set<std::int32_t> all(regions.begin(), regions.end());
  return std::ranges::count_if(all, [](std::int32_t region) { return region >= 0; });
}

std::int64_t PartedMesh::count_left_out() const {
  return std::ranges::count_if(regions, [](std::int32_t region) { return region < 0; });
}

std::shared_ptr<const Diagram> PartedMesh::on_input(std::shared_ptr<const Diagram> diagram) const {
  if (!is_parted()) return diagram;
  return std::make_shared<const Diagram>(restrict_to_input(separated, *diagram));
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

// Listed points are resolved on the input, where a point on a border may belong to any face beside it. So they are
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

// A border belongs to the regions on both of its sides, so a point on it gets one place for each connected part of the
// separated mesh.
PlacedPoints place_points(const Mesh& input, const PartedMesh& parted, const std::vector<SurfacePoint>& points) {
  PlacedPoints placed;
  std::vector<SurfacePoint> seen;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto add = [&](const SurfacePoint& view) {
      placed.places.push_back(view);
      placed.point.push_back(std::int32_t(i));
    };
    if (!parted.is_parted()) {
      add(points[i]);
      continue;
    }
    // Views from the same part are the same point of the separated mesh, and the first of them stands for all.
    seen.clear();
    for (const SurfacePoint& view : find_views(input, points[i])) {
      if (parted.is_left_out(view.face)) continue;
      const SurfacePoint place = canonical(parted.separated.mesh, view);
      if (std::ranges::find(seen, place) != seen.end()) continue;
      seen.push_back(place);
      add(view);
    }
  }
  return placed;
}

std::string describe_left_out(const PartedMesh& parted) {
  const std::int64_t count = parted.count_left_out();
  return count == 0 ? "" : fmt::format("; {} left out", counted(count, "face is", "faces are"));
}

void visit_regions(ObjectVisitor& visitor, const PartedMesh& parted, const char* kept) {
  const Figures figure(visitor, "within", parted.is_parted());
  figure("regions", "", kept, parted.count_regions());
  figure("left_out_faces", "", "in no region", parted.count_left_out());
}

void visit_parted(ObjectVisitor& visitor, const PartedMesh& parted) {
  visit_regions(visitor, parted, "that the cells keep to");
  const RegionSamples& samples = parted.samples;
  const Figures figure(visitor, "within", samples.regions > 0);
  figure("parts", "", "connected parts of regions, where generators are sampled", samples.parts);
  figure("parts_without_generator", "", "of these", samples.empty_parts);
}

}  // namespace gvd
