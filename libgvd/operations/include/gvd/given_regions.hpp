#pragma once

#include <string>

#include "gvd/face_regions.hpp"
#include "gvd/observer.hpp"
#include "gvd/option_list.hpp"
#include "gvd/soup.hpp"

// The options for the regions that cells, distances and paths keep to.
namespace gvd {

struct GivenRegions {
  GivenNumbers within;  ///< the region of each face, as numbers of faces or vertices
  GivenNumbers mask;    ///< not 0 for faces to leave out

  bool are_given() const { return within.is_given() || mask.is_given(); }
};

/// Describes the two options. `kept` says what stays inside the regions, for the help.
void describe(OptionList& list, GivenRegions& given, const std::string& kept);

struct FoundRegions {
  FaceRegions regions;  ///< empty if neither option is given: all faces are one region
  /// The regions of `within` for files; empty without it. A face that the mask leaves out keeps its given number, which
  /// users can look up in their atlas.
  FaceRegions given;
};

/// Converts the numbers to regions. Throws Error{precondition} with the name of the numbers and the vertex or face of
/// the file whose number is invalid. Cost: O(n log n).
FoundRegions find_regions(const CheckedMesh& input, const GivenRegions& given, Observer& observer);

}  // namespace gvd
