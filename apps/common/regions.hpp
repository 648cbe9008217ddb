#pragma once

#include <string>

#include "common/run.hpp"
#include "gvd/face_regions.hpp"
#include "gvd/option_list.hpp"
#include "gvd/soup.hpp"

// The regions of --within and --mask, which gvd-segment and gvd-distance keep to.
namespace gvd::app {

struct RegionFiles {
  GivenNumbers within;  ///< the region of each face
  GivenNumbers mask;    ///< not 0 for the faces to leave out

  bool are_given() const { return within.is_given() || mask.is_given(); }
};

/// Describes the two options. `kept`: what stays inside the regions.
void describe(OptionList& list, RegionFiles& files, const std::string& kept);

struct GivenRegions {
  FaceRegions regions;  ///< empty: neither option is given, and all faces are one region
  /// The regions of --within for files; empty without it. A face that the mask leaves out keeps the number that was
  /// given: users look it up in their atlas.
  FaceRegions given;
};

/// Reads both. Throws Error{unreadable_input} where there is no such file or property, and Error{precondition} with
/// the option, the name, and the vertex or face of the file whose number is none.
GivenRegions read_regions(Run& run, const CheckedMesh& input, const RegionFiles& files);

}  // namespace gvd::app
