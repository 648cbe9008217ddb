// What distances consist of: figures, tables of targets, paths and isolines, and arrays.

#include <algorithm>
#include <cmath>
#include <ostream>
#include <span>
#include <utility>

#include "gvd/distances_operation.hpp"
#include "gvd/text.hpp"

namespace gvd {
namespace {

Table list_targets(const Mesh& mesh, const DistanceTable& table) {
  std::vector<std::int64_t> vertices, faces, sources;
  std::vector<std::vector<double>> bary, positions, distances;
  for (std::size_t i = 0; i < table.targets.size(); ++i) {
    const SurfacePoint& point = table.targets[i];
    const Vec3 p = position(mesh, point);
    vertices.push_back(table.target_vertex(i));
    faces.push_back(point.face.value());
    bary.emplace_back(point.bary.begin(), point.bary.end());
    positions.push_back({p.x(), p.y(), p.z()});
    distances.emplace_back();
    for (const std::span<const double> row : table.rows.each()) distances.back().push_back(row[i]);
    if (!table.nearest.empty()) sources.push_back(table.nearest[i].value());
  }
  return {{"vertex", vertices},    {"face", faces},          {"bary", bary},
          {"position", positions}, {"distances", distances}, {"source", sources}};
}

Table list_paths(const DistanceTable& table) {
  std::vector<std::int64_t> sources, targets, points;
  std::vector<double> lengths;
  std::vector<bool> complete;
  for (const auto& [target, source, path, positions] : table.paths) {
    sources.push_back(source.value());
    targets.push_back(target);
    lengths.push_back(path.length);
    points.push_back(std::ssize(path.points));
    complete.push_back(path.complete);
  }
  return {{"source", sources}, {"target", targets}, {"length", lengths}, {"points", points}, {"complete", complete}};
}

double length_of(const Mesh& mesh, const Isoline& line) {
  double length = 0;
  for (std::size_t i = line.closed ? 0 : 1; i < line.points.size(); ++i) {
    const SurfacePoint& before = i > 0 ? line.points[i - 1] : line.points.back();
    length += (position(mesh, line.points[i]) - position(mesh, before)).norm();
  }
  return length;
}

/// A row for each level.
Table list_isolines(const Mesh& mesh, const std::vector<Isoline>& lines) {
  std::vector<double> levels, lengths;
  std::vector<std::int64_t> curves, closed;
  for (const Isoline& line : lines) {
    if (levels.empty() || levels.back() != line.level) {
      levels.push_back(line.level);
      lengths.push_back(0);
      curves.push_back(0);
      closed.push_back(0);
    }
    lengths.back() += length_of(mesh, line);
    ++curves.back();
    closed.back() += line.closed ? 1 : 0;
  }
  return {{"level", levels}, {"curves", curves}, {"closed", closed}, {"length", lengths}};
}

double largest_of(const DistanceTable& table) {
  double largest = 0;
  for (const double d : table.rows.values()) largest = std::isfinite(d) ? std::max(largest, d) : largest;
  return largest;
}

std::vector<std::int64_t> source_vertices(const DistanceTable& table) {
  std::vector<std::int64_t> vertices;
  for (std::size_t i = 0; i < table.sources.size(); ++i) vertices.push_back(table.source_vertex(GeneratorId(i)));
  return vertices;
}

}  // namespace

void DistancesOutcome::visit(ObjectVisitor& visitor) const {
  const Mesh& mesh = input->mesh;
  const bool is_parted = measured && measured->is_parted();
  visitor.figure({"within.regions", "", "that paths keep to"}, is_parted ? Figure(measured->regions()) : Figure());
  visitor.figure({"within.left_out_faces", "", "in no region"},
                 is_parted ? Figure(measured->left_out_faces()) : Figure());
  visitor.figure({"sources", "", "number of sources"}, std::ssize(table.sources));
  visitor.figure({"source_vertices", "", "that they were given as, by the input's numbers; -1: none"},
                 source_vertices(table));
  visitor.figure({"distances", "", "number of distances"}, std::ssize(table.rows.values()));
  visitor.figure({"unreached", "", "distances that are infinite"}, unreached);
  visitor.figure({"largest", "mesh units", "largest finite distance"}, largest_of(table));
  visitor.table({"targets", "", "points to measure to"}, list_targets(mesh, table));
  visitor.table({"paths", "", "shortest paths"}, list_paths(table));
  visitor.table({"isolines", "", "curves of each level"}, list_isolines(mesh, table.isolines));

  const auto columns = std::int64_t(table.rows.points());
  const std::int64_t stride = sizeof(double);
  visitor.array(
      {"rows", "mesh units",
       "distances: a row for the nearest source, or for each one; of the targets, or else of the vertices of the "
       "input, by its numbers"},
      {table.rows.values().data(),
       ArrayType::float64,
       2,
       {std::int64_t(table.rows.size()), columns},
       {columns * stride, stride}});
  visitor.array({"nearest", "", "the nearest source of each of these; empty with each"}, view(table.nearest));
  visitor.array({"vertex_distances", "mesh units", "of the mesh's vertices from the nearest source; empty with each"},
                view(distance));
  visitor.array({"vertex_labels", "", "that source; -1: none"}, view(label));
  visitor.array({"logarithms", "mesh units",
                 "of each vertex, in the tangent plane at the source: direction and length of the shortest path; not a "
                 "number where none leads"},
                view(logarithms));
  const auto& paths = table.paths;
  visitor.curves({"path", "", "the points of each path, from its target on"},
                 {std::ssize(paths), [&paths](std::int64_t i) {
                    return std::span<const SurfacePoint>(paths[std::size_t(i)].path.points);
                  }});
  const auto& isolines = table.isolines;
  visitor.curves({"isoline", "", "the points of each isoline; the first one of a closed one is not repeated"},
                 {std::ssize(isolines), [&isolines](std::int64_t i) {
                    return std::span<const SurfacePoint>(isolines[std::size_t(i)].points);
                  }});
  visitor.array({"isoline_levels", "mesh units", "the distance of each isoline"}, view(isolines, &Isoline::level));
  visitor.array({"isoline_closed", "", "1 for a loop"}, view(isolines, &Isoline::closed));
}

std::optional<LabelledMesh> DistancesOutcome::labelled() const {
  LabelledMesh mesh{input->mesh};
  mesh.appearance = &input->appearance;
  if (!polylines.empty()) mesh.curves = &polylines;
  if (field == nullptr) return mesh;
  mesh.vertex_label = &label;
  mesh.vertex_distance = &distance;
  return mesh;
}

OwnWriters DistancesOutcome::part_writers(std::string_view part) const {
  constexpr std::string_view kPath = "path ";
  const auto place = part.starts_with(kPath) ? parse_number<std::int64_t>(part.substr(kPath.size())) : std::nullopt;
  if (!place || *place < 0 || *place >= std::ssize(table.paths)) return {};
  DistanceTable one;
  one.paths = {table.paths[std::size_t(*place)]};
  one.source_vertices = table.source_vertices;
  one.target_vertices = {table.target_vertex(std::size_t(one.paths.front().target))};
  one.paths.front().target = 0;
  const std::vector<Vec3>& line = table.paths[std::size_t(*place)].positions;
  return {{"csv", [one = std::move(one)](std::ostream& out) { write_paths_csv(out, one); }},
          {"npy", [&line](std::ostream& out) { write_polyline_npy(out, line); }},
          {"obj", [&line](std::ostream& out) { write_polyline_obj(out, line); }}};
}

OwnWriters DistancesOutcome::own_writers() const {
  const Mesh& mesh = input->mesh;
  return {{"npy", [this](std::ostream& out) { write_distances_npy(out, table); }},
          {"txt", [this](std::ostream& out) { write_distances_text(out, table); }},
          {"csv",
           [this](std::ostream& out) {
             table.paths.empty() ? write_distances_csv(out, table) : write_paths_csv(out, table);
           }},
          {"json", [this, &mesh](std::ostream& out) { write_distances_json(out, mesh, table); }},
          {"shape.gii", [this](std::ostream& out) { write_distances_gifti(out, table); }},
          {"curv", [this, &mesh](std::ostream& out) { write_distances_freesurfer(out, table, mesh.face_count()); }}};
}

}  // namespace gvd
