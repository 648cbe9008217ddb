// What distances consist of: figures, tables of targets, paths and isolines, and arrays.

#include <algorithm>
#include <cmath>
#include <ostream>
#include <utility>

#include "figures.hpp"
#include "gvd/distances_operation.hpp"
#include "gvd/text.hpp"

namespace gvd {
namespace {

Table list_targets(const Mesh& mesh, const DistanceTable& table) {
  std::vector<std::vector<double>> bary, positions, distances;
  std::vector<std::int64_t> vertices;
  for (std::size_t i = 0; i < table.targets.size(); ++i) {
    const SurfacePoint& point = table.targets[i];
    const Vec3 p = position(mesh, point);
    vertices.push_back(table.target_vertex(i));
    bary.emplace_back(point.bary.begin(), point.bary.end());
    positions.push_back({p.x(), p.y(), p.z()});
    distances.push_back(each_of(table.rows.each(), [i](const auto& row) { return row[i]; }));
  }
  return {{"vertex", vertices},
          {"face", each_of(table.targets, &SurfacePoint::face)},
          {"bary", bary},
          {"position", positions},
          {"distances", distances},
          {"source", table.targets.empty() ? std::vector<std::int64_t>() : each_of(table.nearest)}};
}

Table list_paths(const std::vector<TargetPath>& paths) {
  const auto each = [&](auto part) { return each_of(paths, [part](const TargetPath& one) { return part(one.path); }); };
  return {{"source", each_of(paths, &TargetPath::source)},
          {"target", each_of(paths, &TargetPath::target)},
          {"length", each([](const GeodesicPath& path) { return path.length; })},
          {"points", each([](const GeodesicPath& path) { return path.points.size(); })},
          {"complete", each([](const GeodesicPath& path) { return path.complete; })}};
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

}  // namespace

void DistancesOutcome::visit(ObjectVisitor& visitor) const {
  const Mesh& mesh = input->mesh;
  const Figures figure(visitor);
  visit_regions(visitor, parted, "that paths keep to");
  figure("sources", "", "number of sources", table.sources.size());
  figure("source_vertices", "", "that they were given as, by the input's numbers; -1: none",
         each_of(IdRange<GeneratorId>(table.sources.size()), [&](GeneratorId g) { return table.source_vertex(g); }));
  figure("distances", "", "number of distances", table.rows.values().size());
  figure("unreached", "", "distances that are infinite", unreached);
  figure("largest", "mesh units", "largest finite distance", largest_of(table));
  visitor.table({"targets", "", "points to measure to"}, list_targets(mesh, table));
  visitor.table({"paths", "", "shortest paths"}, list_paths(table.paths));
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
  visitor.curves({"path", "", "the points of each path, from its target on"},
                 lists_of(
                     table.paths, [](const TargetPath& one) -> const auto& { return one.path.points; }));
  const auto& isolines = table.isolines;
  visitor.curves({"isoline", "", "the points of each isoline; the first one of a closed one is not repeated"},
                 lists_of(isolines, &Isoline::points));
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
  return {{"csv", [one = std::move(one)](std::ostream& out) { write_paths_csv(out, one); }}};
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
