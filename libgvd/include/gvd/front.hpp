#pragma once

#include "gvd/names.hpp"

namespace gvd {

/// Shape of the wave that a local distance update assumes (section 4.1 of the paper).
enum class Front {
  planar,  ///< linear between the two known distances, as in the paper
  circle,  ///< round a point source that is unfolded from the two known distances
};
inline const Choices<Front> kFrontNames{{"planar", Front::planar}, {"circle", Front::circle}};

}  // namespace gvd
