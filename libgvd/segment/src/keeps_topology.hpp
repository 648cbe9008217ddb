#pragma once

#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// Whether face f can pass from its label to `to` without a change of topology.
///
/// If so: (1) the faces of both labels stay connected, and neither label vanishes; (2) the Euler characteristics of
/// both open regions stay, so discs stay discs; (3) no region touches itself at a vertex where it did not before.
/// It answers no where a vertex that decides has more than 256 faces. Cost: O(1).
bool keeps_topology(const Mesh& mesh, const IdVector<FaceId, GeneratorId>& label, FaceId f, GeneratorId to);

}  // namespace gvd
