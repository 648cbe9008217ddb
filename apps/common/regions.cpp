// --within and --mask: numbers of faces or vertices, from a file or a property of INPUT, as regions of the mesh's
// faces.
//
// Numbers are checked here, before a face takes that of most of its corners: one vertex with "inf" would be outvoted in
// silence. Messages have the vertices and faces of the file, which users can look up.

#include "common/regions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <set>

#include "common/run_parts.hpp"
#include "gvd/error.hpp"

namespace gvd::app {
namespace {

/// Adds the option in front of an error.
template <class Work>
void name_errors(const std::string& option, const std::string& name, const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    if (error.code() != ErrorCode::precondition) throw;
    throw error.at(fmt::format("{} {}", option, name));
  }
}

bool is_whole(double value) {
  using Limits = std::numeric_limits<std::int32_t>;
  return value >= Limits::min() && value <= Limits::max() && value == std::floor(value);
}

/// What an option takes.
struct Wanted {
  bool (*accepts)(double);
  const char *noun, *text;  ///< for messages
};

/// The numbers that an option names.
SoupProperty read_numbers(Run& run, const CheckedMesh& input, const std::string& option, const std::string& name,
                          const Wanted& wanted) {
  SoupProperty numbers = find_numbers(run, input, option, name, read_region_numbers);
  for (std::size_t i = 0; i < numbers.values.size(); ++i) {
    if (wanted.accepts(numbers.values[i])) continue;
    const std::int64_t in_file = numbers.of_vertices ? input.input_vertex[VertexId(i)] : input.input_polygon[FaceId(i)];
    if (in_file < 0) continue;  // the midpoint of a split edge, whose number is that of a vertex beside it
    throw Error(ErrorCode::precondition,
                fmt::format("{} {}: the {} of {} {} is {}; give {}", option, name, wanted.noun,
                            numbers.of_vertices ? "vertex" : "face", in_file, numbers.values[i], wanted.text),
                in_file);
  }
  return numbers;
}

/// A note names this many regions.
constexpr std::ptrdiff_t kNamedRegions = 8;

/// Notes the regions that vertices have and no face: each face took the number of other corners, or of a neighbour.
void note_lost_regions(Run& run, const std::string& name, const SoupProperty& numbers, const FaceRegions& regions) {
  if (!numbers.of_vertices) return;
  std::set<double> lost;
  for (const double number : numbers.values) {
    if (number >= 0 && number < kInfinity) lost.insert(number);
  }
  for (const std::int32_t region : regions) lost.erase(region);
  if (lost.empty()) return;
  const auto end = std::next(lost.begin(), std::min(std::ssize(lost), kNamedRegions));
  run.console().note(fmt::format("--within {}: no face is in {} {}{}: most corners of its faces have other numbers",
                                 name, lost.size() == 1 ? "region" : "regions", fmt::join(lost.begin(), end, ", "),
                                 end == lost.end() ? "" : ", ..."));
}

}  // namespace

void describe(OptionList& list, RegionFiles& files, const std::string& kept) {
  list.option(
      "within", ValueSource{&files.within},
      {.help = fmt::format("Keep {} inside given regions", kept),
       .more = ": a file with a whole number for each face or each vertex, or the name of a property of a PLY, VTP "
               "or VTU input; faces with negative numbers are left out"});
  list.option("mask", ValueSource{&files.mask},
              {.help = "Leave out the faces whose number in this file or property is not 0"});
}

GivenRegions read_regions(Run& run, const CheckedMesh& input, const RegionFiles& files) {
  GivenRegions found;
  if (!files.are_given()) return found;
  const Mesh& mesh = input.mesh;
  found.regions.assign(mesh.face_vertices().size(), 0);
  if (!files.within.empty()) {
    const SoupProperty numbers =
        read_numbers(run, input, "--within", files.within, {is_whole, "region", "whole numbers of 32 bits"});
    name_errors("--within", files.within, [&] { found.regions = make_face_regions(mesh, numbers); });
    if (std::ranges::all_of(found.regions, [](std::int32_t region) { return region < 0; })) {
      throw Error(ErrorCode::precondition,
                  fmt::format("--within {}: no face is left; all numbers are negative", files.within));
    }
    note_lost_regions(run, files.within, numbers, found.regions);
    found.given = found.regions;
  }
  if (!files.mask.empty()) {
    const auto is_finite = [](double value) { return std::isfinite(value); };
    const SoupProperty mask = read_numbers(run, input, "--mask", files.mask, {is_finite, "number", "finite numbers"});
    name_errors("--mask", files.mask, [&] { mask_regions(mesh, mask, found.regions); });
    if (!found.given.empty()) update_numbers(found.regions, found.given);
  }
  return found;
}

}  // namespace gvd::app
