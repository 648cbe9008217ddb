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

/// Curves as a file gives them: points, not yet of a mesh, and the segments between them. A point of no segment is a
/// curve of its own.
struct CurveList {
  GeneratorList points;
  std::vector<std::array<std::int32_t, 2>> segments;  ///< indices of points
  std::vector<std::int32_t> curve;                    ///< of each point, ascending from 0
};

/// Parses curves. `name` is the file's, for messages; its extension and the content tell the format:
/// - OBJ: the statements `v` and `l`; PLY: vertices, and edges by `vertex1` and `vertex2`. Points are positions. Lines
///   that have vertices in common make one curve;
/// - JSON: an array `curves`, `paths`, `isolines` or `bisectors` of objects with an array `points`, whose elements are
///   those of a list of generators, and for closed curves `"closed": true`. So what this library writes serves as well;
/// - text: a list of generators as text, in which a blank line begins another curve.
/// Throws Error{unreadable_input} with name and line; Error{precondition} for a coordinate of an OBJ or PLY that is not
/// finite. Cost: O(length).
CurveList parse_curves(std::string_view content, const std::string& name);
/// The same for a file, also one that gzip packed. Throws Error{unreadable_input} if it can't be read, too.
CurveList read_curves(const std::filesystem::path& path);

/// The curves of a list on a mesh, with what became of the points in `snapped`. Points of a segment that no face
/// contains are joined by the shortest path between them. Curves that have a point in common are one curve. A point
/// nearer to a side of its face than 1e-9 of the height is moved there.
/// Throws what `resolve_generators` throws; Error{precondition} if two points of a segment lie on two components.
/// Cost: that of `resolve_generators`, and of distances up to their neighbour for points that have to be joined.
std::vector<GeneratorCurve> resolve_curves(const Mesh& mesh, const CurveList& list, ResolveOptions options,
                                           ResolvedGenerators& snapped);

}  // namespace gvd
