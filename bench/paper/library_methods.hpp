#pragma once

#include <vector>

#include "comparator.hpp"

namespace gvd::paper {

/// A diagram of this library, in the form of a comparator's result: with the times of the steps until distances are
/// known and of the other ones, and with the faults that its own figures tell. One thread; the whole diagram, cells
/// included.
Comparison run_library_method(const Mesh& mesh, const std::vector<SurfacePoint>& generators, DiagramOptions options);

}  // namespace gvd::paper
