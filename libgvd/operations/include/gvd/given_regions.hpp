#pragma once

#include <string>

#include "gvd/face_regions.hpp"
#include "gvd/observer.hpp"
#include "gvd/option_list.hpp"
#include "gvd/soup.hpp"

// The regions that cells, distances and paths keep to.
namespace gvd {

struct GivenRegions {
  GivenNumbers within;  ///< the region of each face
  GivenNumbers mask;    ///< not 0 for the faces to leave out

  bool are_given() const { return within.is_given() || mask.is_given(); }
};

/// Describes the two options. `kept`: what stays inside the regions.
void describe(OptionList& list, GivenRegions& given, const std::string& kept);

struct FoundRegions {
  FaceRegions regions;  ///< empty: neither option is given, and all faces are one region
  /// The regions of `within` for files; empty without it. A face that the mask leaves out keeps the number that was
  /// given: users look it up in their atlas.
  FaceRegions given;
};

/// Makes both of their numbers. Throws Error{precondition} with the name of the numbers, and the vertex or face of the
/// file whose number is none.
FoundRegions find_regions(const CheckedMesh& input, const GivenRegions& given, Observer& observer);

}  // namespace gvd
