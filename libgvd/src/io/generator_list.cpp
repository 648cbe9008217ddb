// Detects the format of a list of generators, reads and writes the list, and turns its entries into points of a mesh.
// Also reads plain lists of numbers.
//
// The extension of a file decides on its format; without a known extension the content decides: JSON begins with a
// brace or bracket, and CSV has a comma in its first line, or the header `vertex`.
// Text holds only the face and its coordinates; the other formats also hold the position, which other programs can
// read.
//
// Invariant: barycentric coordinates of a surface point are kept bit by bit, so that a written list reads back bit by
// bit, in any locale: fmt writes a double with the fewest digits that read back to the same bits. Whichever step
// refuses an entry, the message gives the name of the list and the line.
#include "gvd/generator_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>

#include "gvd/closest_point.hpp"
#include "gvd/error.hpp"
#include "gvd/read_soup.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/text.hpp"
#include "io/parse_json_lists.hpp"
#include "io/parse_lists.hpp"
#include "io/writers/format_writers.hpp"
#include "mesh/find_coincident.hpp"
#include "mesh/reading/unpack.hpp"

namespace gvd {
namespace {

/// Refuses content that no format of lists allows.
void refuse_foreign(std::string_view content, const std::string& name) {
  if (content.starts_with("\x93NUMPY")) {
    throw Error(ErrorCode::unreadable_input,
                name + ": the file is a NumPy array; write the points as .ply, .xyz or text");
  }
  const std::string_view program = find_compression(content);
  if (program.empty()) return;
  throw Error(ErrorCode::unreadable_input,
              fmt::format("{}: the file is compressed by {}; unpack it first", name, program));
}

/// The content of a file that holds a list.
std::string read_list_file(const std::filesystem::path& path) {
  const auto refuse = [&](std::string_view message) {
    throw Error(ErrorCode::unreadable_input, fmt::format("{}: {}", path.string(), message));
  };
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) refuse("is a directory; name a list of generators");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) refuse(fmt::format("{}; name a list of generators", std::strerror(errno)));
  std::string content = read_to_end(file);
  if (file.bad()) refuse("could not be read to its end");
  return content;
}

std::optional<GeneratorFormat> format_of_extension(const std::filesystem::path& path) {
  const std::string extension = io::bare_extension(path.extension().string());
  for (const auto& [name, format] : kGeneratorFormatNames) {
    if (generator_extension(format) == extension) return format;
  }
  return std::nullopt;
}

std::string text_of(const std::vector<SurfacePoint>& points) {
  std::string out = "# generators: face b0 b1 b2\n";
  for (const auto& [face, bary] : points) {
    fmt::format_to(std::back_inserter(out), "{} {}\n", face.value(), fmt::join(bary, " "));
  }
  return out;
}

std::string csv_of(const Mesh& mesh, const std::vector<SurfacePoint>& points) {
  std::string out = "face,b0,b1,b2,x,y,z\n";
  for (const SurfacePoint& point : points) {
    const Vec3 p = position(mesh, point);
    fmt::format_to(std::back_inserter(out), "{},{},{}\n", point.face.value(), fmt::join(point.bary, ","),
                   fmt::join(p.data(), p.data() + 3, ","));
  }
  return out;
}

std::string json_of(const Mesh& mesh, const std::vector<SurfacePoint>& points) {
  std::string out = "{\"schema\":\"gvd-generators/1\",\"generators\":[";
  const char* separator = "\n";
  for (const SurfacePoint& point : points) {
    const Vec3 p = position(mesh, point);
    fmt::format_to(std::back_inserter(out), "{}{{\"face\":{},\"bary\":[{}],\"position\":[{}]}}", separator,
                   point.face.value(), fmt::join(point.bary, ","), fmt::join(p.data(), p.data() + 3, ","));
    separator = ",\n";
  }
  return out + "\n]}\n";
}

std::string ply_of(const Mesh& mesh, const std::vector<SurfacePoint>& points) {
  std::string out = fmt::format("ply\nformat ascii 1.0\nelement vertex {}\n", points.size());
  for (const char* name : {"double x", "double y", "double z", "int face", "double b0", "double b1", "double b2"}) {
    out += fmt::format("property {}\n", name);
  }
  out += "end_header\n";
  for (const SurfacePoint& point : points) {
    const Vec3 p = position(mesh, point);
    fmt::format_to(std::back_inserter(out), "{} {} {}\n", fmt::join(p.data(), p.data() + 3, " "), point.face.value(),
                   fmt::join(point.bary, " "));
  }
  return out;
}

std::string xyz_of(const Mesh& mesh, const std::vector<SurfacePoint>& points) {
  std::string out;
  for (const SurfacePoint& point : points) {
    const Vec3 p = position(mesh, point);
    fmt::format_to(std::back_inserter(out), "{}\n", fmt::join(p.data(), p.data() + 3, " "));
  }
  return out;
}

class Resolver {
 public:
  Resolver(const Mesh& mesh, const GeneratorList& list, const ResolveOptions& options)
      : mesh_(mesh), list_(list), options_(options) {}

  ResolvedGenerators run() {
    for (const GeneratorEntry& entry : list_.entries) {
      report_progress(options_.progress, "generators", double(result_.points.size()) / double(list_.entries.size()));
      result_.snap_distance.emplace_back();
      result_.points.push_back(resolve(entry));
      result_.vertex.push_back(entry.kind == GeneratorEntry::Kind::vertex ? entry.index : -1);
    }
    if (!options_.keep_coincident) merge_coincident();
    return std::move(result_);
  }

 private:
  std::string location(std::size_t entry) const {
    return detail::ListLocation{list_.name, list_.entries[entry].line}.text();
  }

  [[noreturn]] void refuse(std::size_t entry, const std::string& message) const {
    throw Error(ErrorCode::precondition, location(entry) + ": " + message, std::int64_t(entry));
  }

  /// Refuses the entry that is being resolved.
  [[noreturn]] void refuse(const std::string& message) const { refuse(result_.points.size(), message); }

  SurfacePoint resolve(const GeneratorEntry& entry) {
    if (entry.kind == GeneratorEntry::Kind::vertex) return resolve_vertex(entry.index);
    if (entry.kind == GeneratorEntry::Kind::face) return resolve_face(entry);
    return snap({entry.values[0], entry.values[1], entry.values[2]});
  }

  SurfacePoint resolve_vertex(std::int64_t index) const {
    const std::vector<VertexId>* const map = options_.input_vertices;
    const std::int64_t count = map ? std::ssize(*map) : mesh_.vertex_count();
    if (index < 0 || index >= count)
      refuse(fmt::format("there is no vertex {}; the mesh has {}, numbered from 0", index, count));
    const VertexId v = map ? (*map)[index] : VertexId(index);
    if (!v.valid())
      refuse(fmt::format("vertex {} is in no face of the mesh, or in a component that was dropped; choose another",
                         index));
    return vertex_point(mesh_, v);
  }

  SurfacePoint resolve_face(const GeneratorEntry& entry) const {
    const std::int32_t count = mesh_.face_count();
    if (entry.index < 0 || entry.index >= count) {
      refuse(fmt::format("there is no face {}; the mesh has {}, numbered from 0", entry.index, count));
    }
    try {
      return restore_surface_point(FaceId(entry.index), entry.values);
    } catch (const Error& error) {
      refuse(error.what());
    }
  }

  SurfacePoint snap(const Vec3& given) {
    if (!tree_) tree_.emplace(mesh_);
    ClosestPoint closest;
    try {
      closest = tree_->query(given);
    } catch (const Error& error) {
      refuse(error.what());
    }
    if (options_.max_snap && !(closest.distance <= *options_.max_snap)) {
      refuse(
          fmt::format("this position is {} from the surface, more than the {} allowed; move it, or raise "
                      "\1max_snap\2",
                      closest.distance, *options_.max_snap));
    }
    result_.snap_distance.back() = closest.distance;
    if (closest.distance > result_.longest_snap.value_or(-1)) {
      result_.longest_snap = closest.distance;
      const std::size_t entry = result_.points.size();
      result_.farthest =
          list_.entries[entry].line > 0 ? location(entry) : fmt::format("{}: point {}", list_.name, entry);
    }
    return closest.point;
  }

  /// Leaves out or refuses entries that coincide with an earlier one.
  void merge_coincident() {
    const std::vector<std::int32_t> first = find_coincident(mesh_, result_.points);
    ResolvedGenerators kept;
    kept.longest_snap = result_.longest_snap;
    kept.farthest = result_.farthest;
    for (int i = 0; i < std::ssize(first); ++i) {
      const int twin = first[i];
      if (twin == i) {
        kept.points.push_back(result_.points[i]);
        kept.snap_distance.push_back(result_.snap_distance[i]);
        kept.vertex.push_back(result_.vertex[i]);
      } else if (!options_.merge_coincident) {
        refuse(i,
               describe_coincident(std::size_t(i), std::size_t(twin)) + "; remove one\1+, or add |merge_coincident\2");
      }
    }
    kept.merged = std::int32_t(first.size() - kept.points.size());
    result_ = std::move(kept);
  }

  /// Names the entries by their vertices of the input, if they have some.
  std::string describe_coincident(std::size_t entry, std::size_t twin) const {
    const auto name = [&](std::size_t i) {
      const GeneratorEntry& named = list_.entries[i];
      return named.kind == GeneratorEntry::Kind::vertex ? fmt::format("vertex {}", named.index)
                                                        : fmt::format("point {}", i);
    };
    const std::string line = list_.entries[twin].line > 0 ? fmt::format(" ({})", location(twin)) : "";
    return name(entry) == name(twin) ? name(entry) + " is listed twice" + line
                                     : name(entry) + " is in the same place as " + name(twin) + line;
  }

  const Mesh& mesh_;
  const GeneratorList& list_;
  const ResolveOptions& options_;
  std::optional<ClosestPointTree> tree_;
  ResolvedGenerators result_;
};

}  // namespace

GeneratorFormat detect_generator_format(std::string_view content) {
  if (is_utf16(content)) return detect_generator_format(to_utf8(content));
  if (detect_format(content, "") == MeshFormat::ply) return GeneratorFormat::ply;
  const std::vector<detail::ListLine> lines = detail::split_lines(content, 1);
  const std::string_view first = lines.empty() ? std::string_view() : lines.front().text;
  if (first.starts_with('{') || first.starts_with('[')) return GeneratorFormat::json;
  const bool csv = first.find(',') != first.npos || first == "vertex" || first == "\"vertex\"";
  return csv ? GeneratorFormat::csv : GeneratorFormat::text;
}

GeneratorList parse_generators(std::string_view content, GeneratorFormat format, const std::string& name) {
  if (is_utf16(content)) return parse_generators(to_utf8(content), format, name);
  refuse_foreign(content, name);
  constexpr std::array kParsers{detail::parse_text, detail::parse_csv, detail::parse_json, detail::parse_ply_points,
                                detail::parse_xyz};  // in the order of GeneratorFormat
  const auto parse = kParsers[static_cast<std::size_t>(format)];
  GeneratorList list{name, parse(content, name)};
  if (list.entries.empty())
    throw Error(ErrorCode::unreadable_input, name + ":1: the list holds no generator; write at least one");
  return list;
}

GeneratorList read_generators(const std::filesystem::path& path, std::optional<GeneratorFormat> format) {
  const std::string content = read_list_file(path);
  if (!format) format = format_of_extension(path);
  return parse_generators(content, format ? *format : detect_generator_format(content), path.string());
}

std::string format_generators(const Mesh& mesh, const std::vector<SurfacePoint>& points, GeneratorFormat format) {
  switch (format) {
    case GeneratorFormat::csv:
      return csv_of(mesh, points);
    case GeneratorFormat::json:
      return json_of(mesh, points);
    case GeneratorFormat::ply:
      return ply_of(mesh, points);
    case GeneratorFormat::xyz:
      return xyz_of(mesh, points);
    case GeneratorFormat::text:
      break;
  }
  return text_of(points);
}

std::vector<double> parse_numbers(std::string_view content, const std::string& name) {
  if (is_utf16(content)) return parse_numbers(to_utf8(content), name);
  refuse_foreign(content, name);
  std::vector<double> numbers;
  for (const auto& [text, line] : detail::split_lines(content)) {
    for (const std::string_view field : detail::split_fields(text, ',')) {
      const auto number = parse_number<double>(field);
      if (!number) detail::ListLocation{name, line}.refuse(fmt::format("{} is not a number", quoted(field)));
      numbers.push_back(*number);
    }
  }
  return numbers;
}

std::vector<std::string> generator_extensions() {
  std::vector<std::string> extensions;
  for (const auto& [name, format] : kGeneratorFormatNames) extensions.emplace_back(generator_extension(format));
  return extensions;
}

ResolvedGenerators resolve_generators(const Mesh& mesh, const GeneratorList& list, const ResolveOptions& options) {
  return Resolver(mesh, list, options).run();
}

}  // namespace gvd
