// The parts of distances: figures, tables of targets, paths and isolines, and arrays. The same check tells the commands
// before they measure, and every result that is written later, whether files hold all requested results.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <ostream>
#include <string>
#include <utility>

#include "figures.hpp"
#include "gvd/barriers.hpp"
#include "gvd/distances_operation.hpp"
#include "gvd/error.hpp"
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

/// Makes a table with a row for each level.
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

// ---- files

/// The contents of formats that can hold paths or isolines: curves without a surface, or lines drawn beside one.
constexpr Content kPaths = Content::curves | Content::paths, kIsolines = Content::curves | Content::isolines;
constexpr Content kDistances = Content::distances | Content::rows;

[[noreturn]] void refuse_file(const std::string& message) { throw Error(ErrorCode::invalid_option, message); }

/// Lists formats to write instead.
std::string list_formats(Content any) { return list_extensions(output_extensions(any), "or"); }

std::string named(const WrittenFile& file) {
  return fmt::format("{}: .{}", file.name, file.format->extensions.front());
}

// ---- why distances are infinite: sources and points are in different components, or something separates a component

/// Finds out why distances of a table are infinite.
class UnreachedPoints {
 public:
  /// `of` must outlive this object.
  explicit UnreachedPoints(const DistancesOutcome& of)
      : input_(*of.input),
        parted_(of.parted),
        table_(of.table),
        targets_(of.targets),
        has_limit_(of.has_limit),
        has_mesh_vertices_(of.has_mesh_vertices) {}

  /// The barrier between the sources of a row and a point of the table that they do not reach. Cost: O(1), plus
  /// O(components) when the row changes, and the cost of `Barriers` once.
  Barrier find(std::size_t row, std::size_t point);

  /// The words for Barrier::inside.
  std::string inside() const;

 private:
  void find_faces();

  const CheckedMesh& input_;
  const PartedMesh& parted_;
  const DistanceTable& table_;
  const PlacedPoints& targets_;
  bool has_limit_, has_mesh_vertices_;
  std::optional<Barriers> barriers_;
  std::vector<FaceId> face_;       // a face of each point in the table; invalid for a vertex that no face uses
  std::vector<char> is_left_out_;  // for each point in the table
  std::optional<std::size_t> row_;
  Barriers::Origin origin_;  // the sources of `row_`
};

std::string UnreachedPoints::inside() const {
  if (!parted_.is_parted()) return "beyond \1max_distance\2";
  return has_limit_ ? "in another region, in another part of its region, or beyond \1max_distance\2"
                    : "in another region, or in another part of its region";
}

void UnreachedPoints::find_faces() {
  if (!table_.targets.empty()) {
    for (const SurfacePoint& target : table_.targets) face_.push_back(target.face);
    is_left_out_.assign(face_.size(), 1);
    for (const std::int32_t point : targets_.point) is_left_out_[std::size_t(point)] = 0;
    return;
  }
  IdVector<VertexId, char> is_measured(input_.mesh.vertex_count(), 0);
  for (const FaceId f : input_.mesh.faces()) {
    if (parted_.is_left_out(f)) continue;
    for (const VertexId v : input_.mesh.vertices(f)) is_measured[v] = 1;
  }
  const auto add = [&](VertexId v) {
    face_.push_back(v.valid() ? Mesh::face(input_.mesh.halfedge(v)) : FaceId());
    is_left_out_.push_back(v.valid() && !is_measured[v] ? 1 : 0);
  };
  if (has_mesh_vertices_) {
    for (const VertexId v : input_.mesh.vertices()) add(v);
  } else {
    for (const VertexId v : input_.mesh_vertex) add(v);
  }
}

Barrier UnreachedPoints::find(std::size_t row, std::size_t point) {
  if (!barriers_) {
    barriers_.emplace(input_);
    find_faces();
  }
  if (!face_[point].valid()) return Barrier::no_face;
  if (is_left_out_[point]) return Barrier::left_out;
  if (row_ != row) {
    std::vector<FaceId> sources;
    for (std::size_t i = 0; i < table_.sources.size(); ++i) {
      if (!table_.nearest.empty() || i == row) sources.push_back(table_.sources[i].face);
    }
    origin_ = barriers_->from(sources);
    row_ = row;
  }
  return barriers_->between(origin_, face_[point]);
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
       "distances of the targets, or of the input's vertices in their order: one row for the nearest source, or one "
       "for each source"},
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

AskedDistances asked_of(const DistancesCall& call) {
  return {call.targets.are_listed(), call.each, call.paths, call.isolines.has_value()};
}

void check_files(const AskedDistances& asked, const std::vector<WrittenFile>& files,
                 const std::vector<std::string>& others, bool has_other) {
  /// The first file that carries some of `any`, but nothing of `none`; null if there is none.
  const auto find = [&](Content any, Content none = Content::nothing) {
    const auto found = std::ranges::find_if(files, [&](const WrittenFile& file) {
      return has_any(file.format->carries, any) && !has_any(file.format->carries, none);
    });
    return found == files.end() ? nullptr : &*found;
  };
  const auto loses = [&](bool is_asked, Content any) { return is_asked && !has_other && find(any) == nullptr; };
  if (find(Content::distances, Content::surface) != nullptr && asked.targets) {
    refuse_file(fmt::format("\1to\2: {} hold a distance for each vertex; write {}, or leave \1to\2 out",
                            list_extensions(output_extensions(Content::distances, Content::surface), "and"),
                            list_formats(Content::targets)));
  }
  const WrittenFile* const single = find(Content::distances, Content::rows);
  const bool has_surface = single != nullptr && has_any(single->format->carries, Content::surface);
  if (asked.each && single != nullptr && !(asked.paths && has_surface)) {
    refuse_file(fmt::format("\1each\2: {} hold one distance for each vertex; write {}{}",
                            list_extensions(output_extensions(Content::distances, Content::rows), "and"),
                            list_formats(Content::rows), has_surface ? ", or add \1to\2 and \1paths\2" : ""));
  }
  if (loses(asked.isolines, kIsolines)) {
    refuse_file(fmt::format("\1isolines\2: {} curves; write one of them or leave \1isolines\2 out",
                            only_formats(kIsolines, others)));
  }
  const bool has_curves = asked.paths || asked.isolines;
  if (const WrittenFile* const lines = find(Content::curves, kDistances); lines != nullptr && !has_curves) {
    refuse_file(asked.targets ? fmt::format("{} holds no distances; add \1paths\2 for the shortest paths, or write {}",
                                            named(*lines), list_formats(Content::targets))
                              : fmt::format("{} holds no distances; write {}, or add \1isolines\2", named(*lines),
                                            list_formats(kDistances)));
  }
  const WrittenFile* const mesh = find(Content::distances, Content::targets);
  if (mesh != nullptr && !has_curves && loses(asked.targets, Content::targets)) {
    refuse_file(
        fmt::format("{} has the distances of all vertices, for which \1to\2 does nothing; {}write {}, or leave "
                    "\1to\2 out",
                    named(*mesh), has_any(mesh->format->carries, Content::curves) ? "add \1paths\2, " : "",
                    list_formats(Content::targets)));
  }
  if (loses(asked.paths, kPaths)) {
    refuse_file(
        fmt::format("\1paths\2: {} paths; write one of them or leave \1paths\2 out", only_formats(kPaths, others)));
  }
}

std::string describe_unreached(const DistancesOutcome& outcome) {
  const DistanceTable& table = outcome.table;
  UnreachedPoints unreached(outcome);
  BarrierCounts barriers;
  std::int64_t count = 0;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    for (std::size_t i = 0; i < table.rows.points(); ++i, ++count) {
      if (!std::isfinite(table.rows[row][i])) barriers.add(unreached.find(row, i));
    }
  }
  if (outcome.unreached == 0) return "";
  return fmt::format("{} of {}{} {} inf: {}", outcome.unreached, counted(count, "distance", "distances"),
                     table.targets.empty() ? " to vertices" : "",
                     table.targets.empty() || outcome.unreached > 1 ? "are" : "is",
                     barriers.describe(unreached.inside()));
}

std::vector<std::string> describe_targets(const DistancesOutcome& outcome) {
  const DistanceTable& table = outcome.table;
  const std::size_t all = table.rows.size() * table.targets.size();
  UnreachedPoints unreached(outcome);
  std::vector<std::string> lines;
  for (std::size_t told = 0; told < std::min(all, kToldDistances); ++told) {
    const std::size_t row = told / table.targets.size(), i = told % table.targets.size();
    const double distance = table.rows[row][i];
    const std::string target = table.target_name(i);
    lines.push_back(std::isfinite(distance)
                        ? fmt::format("{} is {:.9g} from {}", target, distance, table.source_name(table.source(row, i)))
                        : fmt::format("{} is not reached from {}: it is {}", target,
                                      table.nearest.empty() ? table.source_name(GeneratorId(row)) : "any source",
                                      describe(unreached.find(row, i), unreached.inside())));
  }
  if (lines.size() < all) lines.push_back(fmt::format("... and {} more", all - lines.size()));
  return lines;
}

}  // namespace gvd
