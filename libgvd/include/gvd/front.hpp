#pragma once

namespace gvd {

/// Shape of the wave that a local distance update assumes (section 4.1 of the paper).
enum class Front {
  planar,  ///< linear between the two known distances: the paper's
  circle,  ///< from a point source unfolded out of the two known distances
};

}  // namespace gvd
