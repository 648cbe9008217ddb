#pragma once

#include <string>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/error.hpp"
#include "gvd/mesh.hpp"

namespace gvd::test {

/// What is wrong with a result, a line each; empty where nothing is.
using Findings = std::vector<std::string>;

/// A message of one line, without a full stop, that says enough.
Findings examine(const Error& error);

/// `check_diagram`, no end unresolved, and every number finite and in its range.
Findings examine(const Mesh& mesh, const Diagram& diagram);

/// Distances and labels at the vertices, and crossings of bisectors with edges, by an exact field of each generator's
/// own.
Findings examine_distances(const Mesh& mesh, const Diagram& diagram);

/// The faces of each label hang together, and each generator has one or is listed as having none.
Findings examine_segmentation(const Mesh& mesh, const Diagram& diagram);

/// Cutting keeps the topology and the area.
Findings examine_cut(const Mesh& mesh, const Diagram& diagram);

}  // namespace gvd::test
