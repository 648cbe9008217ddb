#pragma once

#include "gvd/ids.hpp"

namespace gvd {

/// A part of the mesh that one thread works on at a time (mesh_partitions.hpp).
using PartitionId = Id<struct PartitionTag>;

/// A vertex as one partition knows it. A vertex whose faces lie in several partitions has a copy in each of them; its
/// first copy has the number of the vertex, further ones are numbered beyond the last vertex.
using VertexCopyId = Id<struct VertexCopyTag>;

/// A copy of a vertex that several partitions have, numbered among these alone.
using SharedCopyId = Id<struct SharedCopyTag>;

/// The first copy of a vertex.
inline VertexCopyId first_copy(VertexId v) { return VertexCopyId(v.value()); }

}  // namespace gvd
