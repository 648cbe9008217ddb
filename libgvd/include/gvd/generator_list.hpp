#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/names.hpp"
#include "gvd/progress.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// A generator as a list gives it, not placed on a mesh yet.
struct GeneratorEntry {
  enum class Kind {
    vertex,    ///< `index` is a vertex of the input file
    face,      ///< `index` is a face of the mesh, `values` are barycentric coordinates in it
    position,  ///< `values` are coordinates in mesh units, snapped to the surface
  };
  Kind kind = Kind::vertex;
  std::int64_t index = 0;  ///< 0-based, >= 0
  std::array<double, 3> values{};
  std::int32_t line = 0;  ///< 1-based line of the file; 0 without a file
};

struct GeneratorList {
  std::string name;  ///< name of the file or option, for messages
  std::vector<GeneratorEntry> entries;
};

/// The formats of lists. docs/guide/generators.md describes them.
enum class GeneratorFormat { text, csv, json, ply, xyz };
inline const Choices<GeneratorFormat> kGeneratorFormatNames{{"text", GeneratorFormat::text},
                                                            {"csv", GeneratorFormat::csv},
                                                            {"json", GeneratorFormat::json},
                                                            {"ply", GeneratorFormat::ply},
                                                            {"xyz", GeneratorFormat::xyz}};

/// The extension of files in a format, without a dot.
inline std::string_view generator_extension(GeneratorFormat format) {
  return format == GeneratorFormat::text ? "txt" : name_in(kGeneratorFormatNames, format);
}

/// The extensions of all formats, in the order of GeneratorFormat.
std::vector<std::string> generator_extensions();

/// Detects the format of a list from its content. PLY begins with `ply`, and JSON with a brace or bracket. A list is
/// CSV if its first line that is not empty or a comment contains a comma or is the header `vertex`. Anything else is
/// text, and XYZ is never detected. Cost: O(length).
GeneratorFormat detect_generator_format(std::string_view content);

/// Parses a list, in the same way in any locale. Text may be UTF-16 with a byte order mark. `name` is the name of the
/// file, for messages.
/// Throws Error{unreadable_input}, with name and line, if the list is damaged or holds no generator. Cost: O(length).
GeneratorList parse_generators(std::string_view content, GeneratorFormat format, const std::string& name);

/// Reads a file in the given format. Without one, the extension determines the format (.json, .csv, .txt, .ply or
/// .xyz); with any other extension, the content does. Throws Error{unreadable_input} if the file can't be read, is
/// damaged or holds no generator.
GeneratorList read_generators(const std::filesystem::path& path, std::optional<GeneratorFormat> format = {});

struct ResolveOptions {
  /// The vertex of the mesh for each vertex of the input file; invalid if there is none. If null, the list counts the
  /// vertices of the mesh itself.
  const std::vector<VertexId>* input_vertices = nullptr;
  std::optional<double> max_snap = {};  ///< largest snap distance allowed, mesh units
  bool merge_coincident = false;        ///< leave out entries that coincide with an earlier one
  bool keep_coincident = false;         ///< keep every entry, even if it coincides with another
  Progress progress = {};
};

struct ResolvedGenerators {
  std::vector<SurfacePoint> points;                  ///< in the order of the list
  std::vector<std::optional<double>> snap_distance;  ///< distance from each point to its given position, mesh units;
                                                     ///< empty for entries that are not positions
  std::vector<std::int64_t> vertex;    ///< the vertex of the input file that the entry names; -1 for other entries
  std::optional<double> longest_snap;  ///< the largest of all entries, merged ones included; mesh units
  std::string farthest;                ///< name and line of the entry with the longest snap
  std::int32_t merged = 0;             ///< number of entries left out because an earlier one coincides with them
};

/// Converts the entries of a list to points of `mesh`.
///
/// Properties: (1) the barycentric coordinates of a written SurfacePoint are kept bit by bit, so that a written list
/// comes back unchanged; (2) a position becomes the closest point of the mesh; (3) no two points coincide, unless
/// `keep_coincident` is set.
/// Throws Error{precondition} with name and line:
/// - an index is out of range, or a vertex of the file is in no face;
/// - barycentric coordinates don't describe a point of a triangle;
/// - a snap is longer than `max_snap`;
/// - two entries coincide, and neither `merge_coincident` nor `keep_coincident` is set.
/// Cost: O(n log n) for n entries and, if there are positions, O(m log m) for m faces.
ResolvedGenerators resolve_generators(const Mesh& mesh, const GeneratorList& list, const ResolveOptions& options = {});

/// Formats points as a list that reads back bit by bit, in any locale. All formats but text also contain the positions,
/// for other programs. XYZ contains nothing else, and reads back as the closest points of the mesh.
std::string format_generators(const Mesh& mesh, const std::vector<SurfacePoint>& points, GeneratorFormat format);

}  // namespace gvd
