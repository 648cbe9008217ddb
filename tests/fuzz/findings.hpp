#pragma once

#include <string>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/error.hpp"
#include "gvd/mesh.hpp"

namespace gvd::test {

/// The defects of a result, a line for each; empty for a sound one.
using Findings = std::vector<std::string>;

/// The message must be one line of sufficient length without a full stop.
Findings examine(const Error& error);

/// The violations of `check_diagram`, unresolved ends, and numbers that are not finite or out of range.
Findings examine(const Mesh& mesh, const Diagram& diagram);

/// What `examine_distances` compares: the distances of vertices alone, or labels and crossings with edges as well.
enum class Compare { distances, all };

/// Compares the diagram at vertices and edges with one exact field for each generator.
Findings examine_distances(const Mesh& mesh, const Diagram& diagram, Compare compare);

/// The faces of each label must be connected, and each generator must have one or be listed as having none.
Findings examine_segmentation(const Mesh& mesh, const Diagram& diagram);

/// Cutting must keep the topology and the area.
Findings examine_cut(const Mesh& mesh, const Diagram& diagram);

}  // namespace gvd::test
