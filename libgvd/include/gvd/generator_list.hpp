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

/// A generator as a list gives it, not yet a point of a mesh.
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
  std::string name;  ///< of the file or option, for messages
  std::vector<GeneratorEntry> entries;
};

/// The formats of a list, which docs/guide/generators.md describes.
enum class GeneratorFormat { text, csv, json, ply, xyz };
inline const Choices<GeneratorFormat> kGeneratorFormatNames{{"text", GeneratorFormat::text},
                                                            {"csv", GeneratorFormat::csv},
                                                            {"json", GeneratorFormat::json},
                                                            {"ply", GeneratorFormat::ply},
                                                            {"xyz", GeneratorFormat::xyz}};

/// The extension of its files, without a dot.
inline std::string_view generator_extension(GeneratorFormat format) {
  return format == GeneratorFormat::text ? "txt" : name_in(kGeneratorFormatNames, format);
}

/// The extensions of all lists, in the order of the formats.
std::vector<std::string> generator_extensions();

/// The format that a list is written in. PLY begins with `ply`, JSON with a brace or bracket. A line of CSV that holds
/// more than a comment has a comma, or is the header `vertex`; anything else is text. Cost: O(length).
GeneratorFormat detect_generator_format(std::string_view content);

/// Parses a list in any locale; text may be UTF-16 with a byte order mark. `name` is the file's, for messages.
/// Throws Error{unreadable_input} with name and line. Cost: O(length).
GeneratorList parse_generators(std::string_view content, GeneratorFormat format, const std::string& name);

/// Reads a file in the given format, or else in that of its extension: .json, .csv, .txt, .ply or .xyz, or else in that
/// of its content. Throws Error{unreadable_input} where it can't be read, is damaged or holds no generator.
GeneratorList read_generators(const std::filesystem::path& path, std::optional<GeneratorFormat> format = {});

struct ResolveOptions {
  /// The vertex of the mesh for each vertex of the input file, invalid where there is none. Null: the vertices of the
  /// list are those of the mesh.
  const std::vector<VertexId>* input_vertices = nullptr;
  std::optional<double> max_snap = {};  ///< largest snap distance allowed, mesh units
  bool merge_coincident = false;
  bool keep_coincident = false;  ///< keep every entry, in the same place as another or not
  Progress progress = {};
};

struct ResolvedGenerators {
  std::vector<SurfacePoint> points;                  ///< in the order of the list
  std::vector<std::optional<double>> snap_distance;  ///< from each point to its given position, mesh units
  std::vector<std::int64_t> vertex;                  ///< that its entry names, of the input file; -1 for other entries
  std::optional<double> longest_snap;                ///< of all entries, merged ones too; mesh units
  std::string farthest;                              ///< name and line of the entry with that distance
  std::int32_t merged = 0;                           ///< entries left out because an earlier one coincides with them
};

/// The entries as points of `mesh`.
///
/// Barycentric coordinates of a SurfacePoint are kept bit by bit: a written list comes back unchanged.
/// Throws Error{precondition} with name and line:
/// - an index is out of range, or a vertex of the file is in no face;
/// - the coordinates are no point of a triangle;
/// - a snap is longer than `max_snap`;
/// - two entries coincide, and neither `merge_coincident` nor `keep_coincident` is set.
/// Cost: O(n log n) for n entries and, where there are positions, for the faces.
ResolvedGenerators resolve_generators(const Mesh& mesh, const GeneratorList& list, const ResolveOptions& options = {});

/// The points as a list that reads back bit by bit, in any locale. Positions are written for other programs; XYZ has
/// nothing else, and reads back as the closest points.
std::string format_generators(const Mesh& mesh, const std::vector<SurfacePoint>& points, GeneratorFormat format);

}  // namespace gvd
