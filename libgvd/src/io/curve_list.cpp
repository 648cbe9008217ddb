// Reads lists of curves, and finds their points and segments on a mesh.
//
// OBJ and PLY store lines as edges between numbered vertices, often two vertices a line. Connected edges become one
// curve, so that it does not matter how a program splits a polyline. Points without a line are left out. JSON and text
// list the points of a curve in order.
// Cost: O(length), and one field of distances for each pair of points that a shortest path has to join.
#include "gvd/curve_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/union_find.hpp"
#include "geodesic/windows/propagation/join_points.hpp"
#include "gvd/error.hpp"
#include "gvd/read_soup.hpp"
#include "gvd/text.hpp"
#include "io/parse_json_lists.hpp"
#include "io/parse_lists.hpp"
#include "io/writers/format_writers.hpp"
#include "mesh/find_coincident.hpp"
#include "mesh/reading/readers.hpp"
#include "mesh/reading/unpack.hpp"

namespace gvd {
namespace {

/// Joins edges between positions to curves. Vertices without an edge belong to the surface or to nothing, and are left
/// out. An edge from a vertex to itself is ignored.
CurveList connect_edges(const LineSoup& soup, const std::string& name) {
  UnionFind sets(soup.positions.size());
  std::vector<bool> is_used(soup.positions.size(), false);
  for (const auto& [a, b] : soup.edges) {
    sets.unite(a, b);
    is_used[a] = is_used[b] = true;
  }
  // The vertices of each curve, by the representative of its set.
  std::map<std::int32_t, std::vector<std::int32_t>> curves;
  for (std::int32_t v = 0; v < std::ssize(soup.positions); ++v) {
    if (is_used[v]) curves[sets.find(v)].push_back(v);
  }
  CurveList list{{name, {}}, {}, {}};
  std::vector<std::int32_t> point_of(soup.positions.size(), -1);
  std::int32_t number = 0;
  for (const auto& [first, vertices] : curves) {
    for (const std::int32_t v : vertices) {
      const Vec3& p = soup.positions[v];
      point_of[v] = std::int32_t(list.curve.size());
      list.points.entries.push_back({GeneratorEntry::Kind::position, 0, {p.x(), p.y(), p.z()}, 0});
      list.curve.push_back(number);
    }
    ++number;
  }
  for (const auto& [a, b] : soup.edges) {
    if (a != b) list.segments.push_back({point_of[a], point_of[b]});
  }
  return list;
}

/// Adds a polyline through `points`.
void add_polyline(CurveList& list, const std::vector<GeneratorEntry>& points, bool closed) {
  const auto first = std::int32_t(list.curve.size()), count = std::int32_t(points.size());
  const std::int32_t number = list.curve.empty() ? 0 : list.curve.back() + 1;
  for (std::int32_t i = 0; i < count; ++i) {
    list.points.entries.push_back(points[i]);
    list.curve.push_back(number);
    if (i > 0) list.segments.push_back({first + i - 1, first + i});
  }
  if (closed && count > 2) list.segments.push_back({first + count - 1, first});
}

/// Adds a curve with its segments, as documents of diagrams store it. Checks the segments, because their numbers come
/// from the file.
void add_segments(CurveList& list, const std::vector<GeneratorEntry>& points, const nlohmann::json& segments,
                  const detail::ListLocation& location) {
  const auto first = std::int32_t(list.curve.size()), count = std::int32_t(points.size());
  add_polyline(list, points, false);
  list.segments.erase(list.segments.end() - std::max(0, count - 1), list.segments.end());
  const auto is_index = [count](const nlohmann::json& i) {
    return i.is_number_unsigned() && i.get<std::uint64_t>() < std::uint64_t(count);
  };
  for (const nlohmann::json& ends : segments) {
    if (!ends.is_array() || ends.size() != 2 || !is_index(ends[0]) || !is_index(ends[1])) {
      location.refuse("\"segments\" must be pairs of numbers of the curve's points");
    }
    list.segments.push_back({first + ends[0].get<std::int32_t>(), first + ends[1].get<std::int32_t>()});
  }
}

/// A blank line between two entries separates two curves; a comment does not.
CurveList parse_text_curves(std::string_view content, const std::string& name) {
  CurveList list{{name, {}}, {}, {}};
  std::vector<bool> is_blank;  // for each line
  for (std::size_t start = 0; start < content.size();) {
    const std::size_t end = std::min(content.find('\n', start), content.size());
    is_blank.push_back(content.substr(start, end - start).find_first_not_of(" \t\r\v\f") == std::string_view::npos);
    start = end + 1;
  }
  std::vector<GeneratorEntry> points;
  for (const GeneratorEntry& entry : detail::parse_text(content, name)) {
    const bool begins =
        !points.empty() && std::find(is_blank.begin() + points.back().line, is_blank.begin() + entry.line - 1, true) !=
                               is_blank.begin() + entry.line - 1;
    if (begins) add_polyline(list, std::exchange(points, {}), false);
    points.push_back(entry);
  }
  if (!points.empty()) add_polyline(list, points, false);
  return list;
}

/// Adds a curve from an array of a document. `place` names it in messages: 'element 3 of "paths"'.
void add_json_curve(CurveList& list, const nlohmann::json& curve, const std::string& place,
                    const detail::ListLocation& location) {
  if (!curve.is_object() || !curve.contains("points") || !curve["points"].is_array()) {
    location.refuse(place + " must be an object with an array \"points\"");
  }
  std::vector<GeneratorEntry> points;
  for (const nlohmann::json& point : curve["points"]) {
    if (!point.is_object()) location.refuse(fmt::format("a point of {} is not an object", place));
    points.push_back(detail::read_object(point, location));
  }
  if (curve.contains("segments")) {
    add_segments(list, points, curve["segments"], location);
    return;
  }
  const bool closed = curve.contains("closed") && curve["closed"].is_boolean() && curve["closed"].get<bool>();
  if (!points.empty()) add_polyline(list, points, closed);
}

/// Reads the first array that is not empty. The document of a diagram of curves has both `curves` and `bisectors`, and
/// its generators are the curves. All messages name line 1, because LineReader records only the lines of generators.
CurveList parse_json_curves(std::string_view content, const std::string& name) {
  const nlohmann::json document = detail::parse_document(content, name);
  const detail::ListLocation location{name, 1};
  CurveList list{{name, {}}, {}, {}};
  bool found = false;
  for (const char* key : {"curves", "paths", "isolines", "bisectors"}) {
    if (!document.is_object() || !document.contains(key)) continue;
    found = true;
    const nlohmann::json& curves = document[key];
    if (!curves.is_array()) location.refuse(fmt::format("\"{}\" must be an array", key));
    for (std::size_t i = 0; i < curves.size(); ++i) {
      add_json_curve(list, curves[i], fmt::format("element {} of \"{}\"", i, key), location);
    }
    if (!list.curve.empty()) break;  // a diagram of curves has bisectors, too
  }
  if (!found) location.refuse("there is no array \"curves\", \"paths\", \"isolines\" or \"bisectors\"; write one");
  return list;
}

/// A point that is nearer to a side of its face than this fraction of the face's height is moved onto the side.
/// Positions are rounded, and a point just beside an edge would belong to only one of the edge's faces.
constexpr double kOnSide = 1e-9;

SurfacePoint moved_to_side(const SurfacePoint& point) {
  std::array<double, 3> bary = point.bary;
  for (double& b : bary) b = b < kOnSide ? 0 : b;
  return bary == point.bary ? point : make_surface_point(point.face, bary);
}

/// The number of each point's curve, after curves with a common point were united, such as the paths from one source or
/// the bisectors of a diagram. `first`: for each point, the first point at the same place.
std::vector<std::int32_t> unite_touching(const std::vector<std::int32_t>& curve,
                                         const std::vector<std::int32_t>& first) {
  UnionFind sets(curve.back() + 1);
  for (std::size_t i = 0; i < first.size(); ++i) sets.unite(curve[i], curve[first[i]]);
  std::vector<std::int32_t> number(curve.back() + 1, -1), united;
  std::int32_t count = 0;
  for (std::int32_t c = 0; c <= curve.back(); ++c) {
    if (sets.find(c) == c) number[c] = count++;
  }
  for (const std::int32_t c : curve) united.push_back(number[sets.find(c)]);
  return united;
}

}  // namespace

CurveList parse_curves(std::string_view content, const std::string& name) {
  if (is_utf16(content)) return parse_curves(to_utf8(content), name);
  const std::string extension = io::bare_extension(std::filesystem::path(name).extension().string());
  const std::optional<MeshFormat> format = detect_format(content, name);
  CurveList list;
  if (extension == "obj" || (extension != "txt" && format == MeshFormat::obj)) {
    list = connect_edges(parse_obj_lines(content, name), name);
  } else if (format == MeshFormat::ply) {
    list = connect_edges(parse_ply_lines(content, name), name);
  } else if (detect_generator_format(content) == GeneratorFormat::json) {
    list = parse_json_curves(content, name);
  } else {
    list = parse_text_curves(content, name);
  }
  if (list.curve.empty()) {
    throw Error(ErrorCode::unreadable_input, fmt::format("{}: the file holds no curve; write at least one", name));
  }
  return list;
}

CurveList read_curves(const std::filesystem::path& path) { return parse_curves(read_file_bytes(path), path.string()); }

std::vector<GeneratorCurve> resolve_curves(const Mesh& mesh, const CurveList& list, ResolveOptions options,
                                           ResolvedGenerators& snapped) {
  options.keep_coincident = true;
  snapped = resolve_generators(mesh, list.points, options);
  for (SurfacePoint& point : snapped.points) point = moved_to_side(point);
  const std::vector<std::int32_t> first = find_coincident(mesh, snapped.points);
  const std::vector<std::int32_t> curve_of = unite_touching(list.curve, first);
  std::vector<GeneratorCurve> curves(*std::ranges::max_element(curve_of) + 1);
  std::vector<std::int32_t> number;  // of each point within its curve
  for (std::size_t i = 0; i < curve_of.size(); ++i) {
    GeneratorCurve& curve = curves[curve_of[i]];
    const bool is_first = first[i] == std::int32_t(i);
    number.push_back(is_first ? std::int32_t(curve.points.size()) : number[first[i]]);
    if (is_first) curve.points.push_back(snapped.points[i]);
  }
  for (const auto& [a, b] : list.segments) {
    GeneratorCurve& curve = curves[curve_of[a]];
    std::int32_t last = number[a];
    if (last == number[b]) continue;  // both points are at the same place
    for (const SurfacePoint& p : join_points(mesh, snapped.points[a], snapped.points[b])) {
      curve.segments.push_back({last, std::int32_t(curve.points.size())});
      last = std::int32_t(curve.points.size());
      curve.points.push_back(p);
    }
    curve.segments.push_back({last, number[b]});
  }
  return curves;
}

}  // namespace gvd
