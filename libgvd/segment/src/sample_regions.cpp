// Samples generators inside regions: decides how many each connected part gets, and places them.
//
// A part is sampled as a mesh of its own, whose vertices and faces keep the order of the input, so the points are the
// same as if the part were a separate file. The counts follow the method of the largest remainder (A. Hamilton, 1792),
// first over regions, then over the parts of each region. A share below its minimum is raised to it, and the rest is
// divided again among the other shares.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "gvd/error.hpp"
#include "gvd/face_regions.hpp"
#include "gvd/text.hpp"
#include "mesh/submesh.hpp"

namespace gvd {
namespace {

/// A connected part of a region.
struct Part {
  double area = 0;
  std::vector<FaceId> faces;  ///< ascending
  std::int64_t count = 0;     ///< number of generators
};

/// The parts of each region, in the order of their first faces.
using RegionParts = std::map<std::int32_t, std::vector<Part>>;

/// Collects the connected parts of all regions. Faces that are left out belong to none.
RegionParts collect_parts(const Mesh& mesh, const FaceRegions& regions) {
  const IdVector<FaceId, std::int32_t> component = compute_face_components(mesh);
  const std::int32_t count = 1 + *std::max_element(component.begin(), component.end());
  std::vector<Part> parts(static_cast<std::size_t>(count));
  for (const FaceId f : mesh.faces()) {
    Part& part = parts[std::size_t(component[f])];
    part.faces.push_back(f);
    part.area += mesh.area(f);
  }
  RegionParts found;
  for (Part& part : parts) {
    const std::int32_t region = regions[part.faces.front()];
    if (region >= 0) found[region].push_back(std::move(part));
  }
  return found;
}

std::vector<double> areas_of(const std::vector<Part>& parts) {
  std::vector<double> areas;
  for (const Part& part : parts) areas.push_back(part.area);
  return areas;
}

/// Divides `count` generators among the parts of a region. If there are too few, the largest parts get one each.
void share_out_to_parts(std::int64_t count, std::vector<Part>& parts) {
  if (count >= std::ssize(parts)) {
    const std::vector<std::int64_t> shares =
        share_out(count, areas_of(parts), std::vector<std::int64_t>(parts.size(), 1));
    for (std::size_t i = 0; i < parts.size(); ++i) parts[i].count = shares[i];
    return;
  }
  std::vector<std::size_t> order(parts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::greater<>(), [&](std::size_t i) { return parts[i].area; });
  for (std::int64_t i = 0; i < count; ++i) parts[order[std::size_t(i)]].count = 1;
}

/// Divides the generators first among regions and then among the parts of each region, so that a region's number
/// depends on its area and not on its number of parts.
void share_out_to_regions(const RegionSamplingOptions& options, RegionParts& regions) {
  const std::int64_t count = options.sampling.count;
  if (!options.each_region && count < std::ssize(regions)) {
    throw Error(ErrorCode::precondition,
                fmt::format("{} for {}; ask for one or more in each", counted(count, "generator", "generators"),
                            counted(std::ssize(regions), "region", "regions")));
  }
  std::vector<double> areas;
  std::vector<std::int64_t> least;
  std::int64_t parts = 0;
  for (const auto& [number, region] : regions) {
    const std::vector<double> of_parts = areas_of(region);
    areas.push_back(std::accumulate(of_parts.begin(), of_parts.end(), 0.0));
    least.push_back(std::ssize(region));
    parts += std::ssize(region);
  }
  // If there are too few for all parts, at least each region gets one.
  if (count < parts) least.assign(regions.size(), 1);
  std::vector<std::int64_t> shares(regions.size(), count);
  if (!options.each_region) shares = share_out(count, areas, least);
  auto share = shares.begin();
  for (auto& [number, region] : regions) share_out_to_parts(*share++, region);
}

}  // namespace

std::vector<std::int64_t> share_out(std::int64_t total, const std::vector<double>& weights,
                                    const std::vector<std::int64_t>& least) {
  std::vector<std::int64_t> shares = least;
  std::vector<std::size_t> open(weights.size());
  std::iota(open.begin(), open.end(), std::size_t{0});
  std::vector<double> exact(weights.size());
  // A raised share takes from the others, and may bring one of them below its minimum. This ends when no share is
  // raised.
  for (std::size_t before = 0; before != open.size();) {
    before = open.size();
    double weight = 0;
    for (const std::size_t i : open) weight += weights[i];
    const auto exact_share = [&](std::size_t i) {
      return double(total) * (weight > 0 ? weights[i] / weight : 1 / double(before));
    };
    // All shares are computed before one is raised, so the result does not depend on the order.
    for (const std::size_t i : open) exact[i] = exact_share(i);
    const auto is_raised = [&](std::size_t i) { return exact[i] < double(least[i]); };
    for (const std::size_t i : open) total -= is_raised(i) ? least[i] : 0;
    std::erase_if(open, is_raised);
  }
  for (const std::size_t i : open) {
    shares[i] = std::int64_t(std::floor(exact[i]));
    total -= shares[i];
  }
  std::ranges::stable_sort(open, std::greater<>(), [&](std::size_t i) { return exact[i] - double(shares[i]); });
  for (std::size_t k = 0; total > 0; ++k, --total) ++shares[open[k % open.size()]];
  return shares;
}

RegionSamples sample_regions(const SeparatedMesh& separated, const FaceRegions& regions,
                             const RegionSamplingOptions& options) {
  RegionParts found = collect_parts(separated.mesh, regions);
  if (found.empty()) throw Error(ErrorCode::precondition, "no face is in a region: all have negative numbers");
  const bool covers = options.sampling.kind == Sampling::covering_radius;
  if (!covers) share_out_to_regions(options, found);
  RegionSamples result;
  std::size_t done_faces = 0;
  // Adds the points of a part, with their faces in the whole mesh.
  const auto sample = [&](std::int32_t region, const Part& part) {
    SamplingOptions sampling = options.sampling;
    sampling.count = static_cast<std::int32_t>(part.count);
    if (!(part.area > 0) && !covers) sampling.kind = Sampling::farthest;
    // Larger parts take longer. The number of faces measures that well enough for a progress bar.
    sampling.progress = [&](std::string_view step, double fraction) {
      const double done = double(done_faces) + fraction * double(part.faces.size());
      return !options.sampling.progress || options.sampling.progress(step, done / separated.mesh.face_count());
    };
    try {
      // Sorted by the input's vertices, the part's vertices have the order that they would have in a file of their own.
      const Submesh alone = make_submesh(separated.mesh, part.faces, separated.input_vertex);
      for (const SurfacePoint& point : sample_generators(alone.mesh, sampling)) {
        result.points.push_back(alone.to_whole(point));
      }
    } catch (const Error& error) {
      if (error.code() == ErrorCode::interrupted) throw;
      throw error.at(fmt::format("region {}", region));
    }
    done_faces += part.faces.size();
  };
  for (const auto& [number, parts] : found) {
    ++result.regions;
    for (const Part& part : parts) {
      ++result.parts;
      if (covers || part.count > 0) sample(number, part);
      if (!covers && part.count == 0) ++result.empty_parts;
    }
  }
  return result;
}

void move_into_regions(const Mesh& mesh, const FaceRegions& regions, std::vector<SurfacePoint>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto region_of = [&](const SurfacePoint& view) { return order_of(regions[view.face]); };
    points[i] = std::ranges::min(find_views(mesh, points[i]), {}, region_of);
    if (regions[points[i].face] >= 0) continue;
    throw Error(ErrorCode::precondition, fmt::format("generator {} lies on a face that is left out; choose another", i),
                std::int64_t(i));
  }
}

IdVector<FaceId, GeneratorId> label_level(const Mesh& mesh, const FaceRegions& regions, const LevelOptions& options) {
  if (regions.empty()) {
    const Diagram diagram =
        compute_diagram(mesh, sample_generators(mesh, options.generators.sampling), options.diagram);
    return segment_faces(mesh, diagram, options.labels).face_label;
  }
  const SeparatedMesh separated = separate_regions(mesh, regions);
  const RegionSamples samples = sample_regions(separated, regions, options.generators);
  const Diagram diagram = compute_diagram(separated.mesh, samples.points, options.diagram);
  return segment_faces(separated.mesh, diagram, options.labels).face_label;
}

}  // namespace gvd
