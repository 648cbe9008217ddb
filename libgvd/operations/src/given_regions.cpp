// Turns numbers of faces or vertices into regions of the mesh's faces.
//
// Numbers are checked before a face takes the number of most of its corners, because a single vertex with "inf" would
// be outvoted silently. Messages name vertices and faces of the file, which users can look up.

#include "gvd/given_regions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <set>

#include "gvd/error.hpp"
#include "gvd/read_values.hpp"

namespace gvd {
namespace {

/// Puts the name of the numbers in front of an error.
template <class Work>
void name_errors(const GivenNumbers& given, const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    if (error.code() != ErrorCode::precondition) throw;
    throw error.at(given.values->title);
  }
}

bool is_whole(double value) {
  using Limits = std::numeric_limits<std::int32_t>;
  return value >= Limits::min() && value <= Limits::max() && value == std::floor(value);
}

/// The numbers that an option accepts.
struct Wanted {
  bool (*accepts)(double);
  const char *noun, *text;  ///< for messages
};

/// Converts the numbers of an option, and refuses numbers that it does not accept.
SoupProperty to_numbers(const CheckedMesh& input, const GivenNumbers& given, const Wanted& wanted) {
  SoupProperty numbers = to_region_numbers(input, *given.values);
  for (std::size_t i = 0; i < numbers.values.size(); ++i) {
    if (wanted.accepts(numbers.values[i])) continue;
    const std::int64_t in_file = numbers.of_vertices ? input.input_vertex[VertexId(i)] : input.input_polygon[FaceId(i)];
    if (in_file < 0) continue;  // the midpoint of a split edge, which has the number of a vertex beside it
    throw Error(ErrorCode::precondition,
                fmt::format("{}: the {} of {} {} is {}; give {}", given.values->title, wanted.noun,
                            numbers.of_vertices ? "vertex" : "face", in_file, numbers.values[i], wanted.text),
                in_file);
  }
  return numbers;
}

/// A note names at most this many regions.
constexpr std::ptrdiff_t kNamedRegions = 8;

/// Notes regions that vertices have but no face, because each face took the number of other corners or of a neighbour.
void note_lost_regions(Observer& observer, const std::string& name, const SoupProperty& numbers,
                       const FaceRegions& regions) {
  if (!numbers.of_vertices) return;
  std::set<double> lost;
  for (const double number : numbers.values) {
    if (number >= 0 && number < kInfinity) lost.insert(number);
  }
  for (const std::int32_t region : regions) lost.erase(region);
  if (lost.empty()) return;
  const auto end = std::next(lost.begin(), std::min(std::ssize(lost), kNamedRegions));
  observer.note(fmt::format("{}: no face is in {} {}{}: most corners of its faces have other numbers", name,
                            lost.size() == 1 ? "region" : "regions", fmt::join(lost.begin(), end, ", "),
                            end == lost.end() ? "" : ", ..."));
}

}  // namespace

void describe(OptionList& list, GivenRegions& given, const std::string& kept) {
  list.option(
      "within", ValueSource{&given.within, {}, ValueSource::Of::faces},
      {.help = fmt::format("Keep {} inside given regions", kept),
       .more = ": a file with a whole number for each face or each vertex, or the name of a property of a PLY, VTP "
               "or VTU input; faces with negative numbers are left out",
       .arrays = fmt::format("Keep {} inside given regions: a whole number for each face or each vertex; faces with "
                             "negative numbers are left out",
                             kept)});
  list.option("mask", ValueSource{&given.mask, {}, ValueSource::Of::faces},
              {.help = "Leave out the faces whose number in this file or property is not 0",
               .arrays = "Leave out faces: a number for each face or each vertex, 0 for those that stay"});
}

FoundRegions find_regions(const CheckedMesh& input, const GivenRegions& given, Observer& observer) {
  FoundRegions found;
  if (!given.are_given()) return found;
  const Mesh& mesh = input.mesh;
  found.regions.assign(mesh.face_vertices().size(), 0);
  if (given.within.values) {
    const std::string& name = given.within.values->title;
    const SoupProperty numbers = to_numbers(input, given.within, {is_whole, "region", "whole numbers of 32 bits"});
    name_errors(given.within, [&] { found.regions = make_face_regions(mesh, numbers); });
    if (std::ranges::all_of(found.regions, [](std::int32_t region) { return region < 0; })) {
      throw Error(ErrorCode::precondition,
                  fmt::format("{}: all numbers are negative, so no face remains; give numbers from 0 for the faces "
                              "of regions",
                              name));
    }
    note_lost_regions(observer, name, numbers, found.regions);
    found.given = found.regions;
  }
  if (given.mask.values) {
    const auto is_finite = [](double value) { return std::isfinite(value); };
    const SoupProperty mask = to_numbers(input, given.mask, {is_finite, "number", "finite numbers"});
    name_errors(given.mask, [&] { mask_regions(mesh, mask, found.regions); });
    if (!found.given.empty()) update_numbers(found.regions, found.given);
  }
  return found;
}

}  // namespace gvd
