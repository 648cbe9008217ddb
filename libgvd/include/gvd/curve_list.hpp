#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "gvd/generator_curve.hpp"
#include "gvd/generator_list.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// Curves as a file gives them: points that are not placed on a mesh yet, and the segments between them. A point
/// without a segment is a curve of its own.
struct CurveList {
  GeneratorList points;
  std::vector<std::array<std::int32_t, 2>> segments;  ///< indices of points
  std::vector<std::int32_t> curve;                    ///< the number of each point's curve, ascending from 0
};

/// Parses curves. `name` is the name of the file, for messages; its extension and the content determine the format:
/// - OBJ: the statements `v` and `l`; PLY: vertices, and edges by `vertex1` and `vertex2`. Points are positions. Lines
///   that have vertices in common make one curve;
/// - JSON: an array `curves`, `paths`, `isolines` or `bisectors` of objects with an array `points`, whose elements are
///   those of a list of generators, and for closed curves `"closed": true`. Files that this library writes can be read,
///   too;
/// - text: a list of generators as text, in which a blank line begins a new curve.
/// Throws Error{unreadable_input}, with name and line, if the content is damaged or holds no curve; Error{precondition}
/// for a coordinate of an OBJ or PLY that is not finite. Cost: O(length).
CurveList parse_curves(std::string_view content, const std::string& name);
/// Reads and parses a file, which may be compressed by gzip. Throws what `parse_curves` throws, and
/// Error{unreadable_input} if the file can't be read.
CurveList read_curves(const std::filesystem::path& path);

/// Places the curves of a list on a mesh, and stores in `snapped` what became of their points.
///
/// Properties: (1) if no face contains both points of a segment, the shortest path between them joins them; (2) curves
/// that have a point in common become one curve; (3) a point whose distance from a side of its face is less than 1e-9
/// of the height over that side is moved to the side.
/// Throws what `resolve_generators` throws; Error{precondition} if two points of a segment lie on two components.
/// Cost: that of `resolve_generators` and, for each pair of points that has to be joined, of exact distances from one
/// up to the other.
std::vector<GeneratorCurve> resolve_curves(const Mesh& mesh, const CurveList& list, ResolveOptions options,
                                           ResolvedGenerators& snapped);

}  // namespace gvd
