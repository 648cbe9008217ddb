// The operation `distances`: exact distances on the surface from points or curves, shortest paths, and isolines.
//
// A single exact field gives the distances from the nearest source; with `each`, every thread computes whole rows, one
// for each source. The distances form a table with a row for each field. Its columns are the vertices, numbered as in
// the input, or the targets. Unused vertices of the input are infinitely far; if the repair cut a vertex into copies,
// the nearest copy counts.
//
// Regions separate the surface. A point on the border of regions lies in each of them, so it may have several places:
// fields are computed from all places of the sources, and the distance of a point is the least distance of its places.

#include "gvd/distances_operation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/parallel_chunks.hpp"
#include "gvd/error.hpp"
#include "gvd/io/format.hpp"
#include "gvd/read_values.hpp"
#include "gvd/text.hpp"

namespace gvd {
namespace {

/// More levels would fill the memory, and nobody could distinguish them.
constexpr double kMostLevels = 10'000;

[[noreturn]] void refuse_call(const std::string& message) { throw Error(ErrorCode::invalid_option, message); }

ExactFieldOptions field_options(const DistancesCall& call, Observer& observer) {
  ExactFieldOptions options;
  options.threads = observer.threads;
  options.progress = progress_of(observer);
  options.max_distance = call.max_distance.value_or(kInfinity);
  return options;
}

/// Calls take(i, v) for each vertex i of the file and each vertex v of the mesh that i became. There are several v if
/// the repair cut i, and several i if it welded vertices.
template <class Take>
void match_vertices(const CheckedMesh& input, const Take& take) {
  for (std::size_t i = 0; i < input.mesh_vertex.size(); ++i) {
    if (input.mesh_vertex[i].valid()) take(i, input.mesh_vertex[i]);
  }
  for (const VertexId v : input.mesh.vertices()) {
    if (input.input_vertex[v] >= 0) take(std::size_t(input.input_vertex[v]), v);
  }
}

/// The nearest source of each point, and its distance.
struct NearestSources {
  std::vector<double> distance;
  std::vector<GeneratorId> source;

  explicit NearestSources(std::size_t points) : distance(points, kInfinity), source(points) {}
  void take(std::size_t point, double d, GeneratorId from) {
    if (!(d < distance[point])) return;
    distance[point] = d;
    source[point] = from;
  }
};

/// The source of a place, in a field from all places of the sources.
GeneratorId source_at(const DistancesOutcome& made, GeneratorId place) {
  return place.valid() && !made.sources.point.empty() ? GeneratorId(made.sources.point[place.index()]) : place;
}

/// The nearest source of each vertex of the input's mesh, which may be at several places of the surface.
NearestSources find_nearest_of_vertices(const DistancesOutcome& made, const ExactField& field) {
  NearestSources found(std::size_t(made.input->mesh.vertex_count()));
  for (const VertexId v : made.surface().vertices()) {
    found.take(made.parted.input_vertex(v).index(), field.distance(v), source_at(made, field.label(v)));
  }
  return found;
}

/// Adds the distances of the field in the order of the table's points, and the nearest sources.
void add_nearest(DistancesOutcome& made) {
  const NearestSources vertices = find_nearest_of_vertices(made, *made.field);
  made.distance = IdVector<VertexId, double>(vertices.distance);
  made.label = IdVector<VertexId, GeneratorId>(vertices.source);
  DistanceTable& table = made.table;
  NearestSources found(table.targets.empty() ? made.input->mesh_vertex.size() : table.targets.size());
  for (std::size_t i = 0; i < made.targets.places.size(); ++i) {
    const ExactField::Nearest nearest = made.field->nearest(made.targets.places[i]);
    found.take(std::size_t(made.targets.point[i]), nearest.distance, source_at(made, nearest.generator));
  }
  if (table.targets.empty()) {
    match_vertices(*made.input, [&](std::size_t i, VertexId v) {
      found.take(i, vertices.distance[v.index()], vertices.source[v.index()]);
    });
  }
  table.rows = std::move(found.distance);
  table.nearest = std::move(found.source);
}

/// How many sources are computed together: enough for all cores, and with little memory compared with the table.
constexpr std::size_t kSourcesAtOnce = 64;

/// Refuses a table larger than the caller allows, before any work.
void check_table(double most, std::size_t sources, std::size_t points) {
  const double needed = double(sources) * double(points) * sizeof(double);
  if (needed <= most) return;
  refuse_call(
      fmt::format("\1each\2: {} sources and {} points make a table of {:.3g} GB, and at most {:.3g} GB fit; give fewer "
                  "sources, or \1to\2; Python's distance_rows computes row by row",
                  sources, points, needed / 1e9, most / 1e9));
}

/// The vertices at which the points lie; empty if any point is at no vertex.
std::vector<VertexId> find_vertices(const Mesh& mesh, const std::vector<SurfacePoint>& points) {
  std::vector<VertexId> found;
  for (const SurfacePoint& point : points) {
    const auto corner = std::ranges::find(point.bary, 1.0);
    if (corner == point.bary.end()) return {};
    found.push_back(mesh.vertices(point.face)[std::size_t(corner - point.bary.begin())]);
  }
  return found;
}

/// Fills `row` with the distance of each target at its nearest place. `found`: the distances of the places, or of all
/// vertices if each place is a vertex of `at`.
void keep_least_of_targets(const PlacedPoints& targets, std::span<const double> found, const std::vector<VertexId>& at,
                           std::span<double> row) {
  for (std::size_t k = 0; k < targets.places.size(); ++k) {
    double& least = row[std::size_t(targets.point[k])];
    least = std::min(least, found[at.empty() ? k : at[k].index()]);
  }
}

/// Fills `row` with the distances of the mesh's vertices or of the file's. `found`: the distances of the surface's
/// vertices, among which may be several copies of a vertex of the mesh. `of_vertices`: memory to reuse.
void keep_least_of_vertices(const DistancesOutcome& made, std::span<const double> found,
                            std::vector<double>& of_vertices, std::span<double> row) {
  of_vertices.assign(std::size_t(made.input->mesh.vertex_count()), kInfinity);
  for (const VertexId v : made.surface().vertices()) {
    double& least = of_vertices[made.parted.input_vertex(v).index()];
    least = std::min(least, found[v.index()]);
  }
  if (made.has_mesh_vertices) {
    std::ranges::copy(of_vertices, row.begin());
    return;
  }
  match_vertices(*made.input, [&](std::size_t i, VertexId v) { row[i] = std::min(row[i], of_vertices[v.index()]); });
}

/// Adds a row of distances for each source.
void add_rows(const DistancesCall& call, Observer& observer, DistancesOutcome& made) {
  const CheckedMesh& input = *made.input;
  const Mesh& mesh = made.surface();
  DistanceTable& table = made.table;
  const bool has_targets = !table.targets.empty();
  const std::vector<SurfacePoint>& sources = made.sources.places;
  // If all targets are vertices, they are picked from whole rows, which takes less work than computing points inside
  // faces.
  const std::vector<VertexId> at = find_vertices(mesh, made.targets.places);
  const bool has_points = has_targets && at.empty();
  const std::size_t places = has_points ? made.targets.places.size() : std::size_t(mesh.vertex_count());
  const std::size_t points = has_targets              ? table.targets.size()
                             : made.has_mesh_vertices ? std::size_t(input.mesh.vertex_count())
                                                      : input.mesh_vertex.size();
  check_table(call.most_bytes, table.sources.size(), points);
  table.rows = {std::vector<double>(table.sources.size() * points, kInfinity), table.sources.size()};
  if (has_targets && made.targets.places.empty()) return;  // all targets lie in faces that are left out
  ExactFieldOptions options = field_options(call, observer);
  std::vector<double> rows, of_vertices;
  for (std::size_t begin = 0; begin < sources.size(); begin += kSourcesAtOnce) {
    const std::size_t end = std::min(begin + kSourcesAtOnce, sources.size());
    rows.resize((end - begin) * places);
    options.progress = [&](std::string_view step, double done) {
      return observer.progress(step, (double(begin) + done * double(end - begin)) / double(sources.size()));
    };
    compute_distance_rows(mesh, {sources.begin() + std::ptrdiff_t(begin), sources.begin() + std::ptrdiff_t(end)},
                          has_points ? &made.targets.places : nullptr, rows, options);
    for (std::size_t source = begin; source < end; ++source) {
      const auto found = std::span(rows).subspan((source - begin) * places, places);
      const std::span<double> row = table.rows[std::size_t(made.sources.point[source])];
      if (has_targets) {
        keep_least_of_targets(made.targets, found, at, row);
      } else {
        keep_least_of_vertices(made, found, of_vertices, row);
      }
    }
  }
}

/// Adds a path from each target, starting at its nearest place. `only`: the source if the field has only one.
void add_paths(DistancesOutcome& made, const ExactField& field, GeneratorId only) {
  DistanceTable& table = made.table;
  std::vector<std::optional<SurfacePoint>> starts(table.targets.size());
  std::vector<double> least(table.targets.size(), kInfinity);
  for (std::size_t k = 0; k < made.targets.places.size(); ++k) {
    const std::size_t target = std::size_t(made.targets.point[k]);
    const double d = field.nearest(made.targets.places[k]).distance;
    if (!(d < least[target])) continue;
    least[target] = d;
    starts[target] = made.targets.places[k];
  }
  for (std::size_t i = 0; i < table.targets.size(); ++i) {
    GeodesicPath path{.points = {}, .generator = {}, .length = kInfinity};
    if (starts[i]) path = field.path(*starts[i]);
    const GeneratorId source = only.valid() && path.generator.valid() ? only : source_at(made, path.generator);
    TargetPath& added = table.paths.emplace_back(TargetPath{std::int32_t(i), source, std::move(path)});
    for (const SurfacePoint& point : added.path.points) added.positions.push_back(position(made.surface(), point));
  }
}

/// Adds the paths from all targets to each source.
void add_all_paths(const DistancesCall& call, Observer& observer, DistancesOutcome& made) {
  ExactFieldOptions options = field_options(call, observer);
  const PlacedPoints& sources = made.sources;
  const std::size_t count = made.table.sources.size();
  for (std::size_t i = 0, begin = 0; i < count; ++i) {
    options.progress = [&](std::string_view, double done) {
      return observer.progress("paths", (double(i) + done) / double(count));
    };
    std::vector<SurfacePoint> places;
    for (; begin < sources.places.size() && sources.point[begin] == std::int32_t(i); ++begin) {
      places.push_back(sources.places[begin]);
    }
    add_paths(made, ExactField(made.surface(), places, options), GeneratorId(i));
  }
}

std::vector<double> choose_levels(const Mesh& mesh, const ExactField& field, const DistancesCall& call) {
  if (call.levels.values) return call.levels.values->soup.values;
  double largest = 0;
  for (const VertexId v : mesh.vertices()) {
    if (std::isfinite(field.distance(v))) largest = std::max(largest, field.distance(v));
  }
  // Every point of a face is at most its longest edge away from each of its vertices.
  const double step = *call.isolines;
  const double last = std::min(largest + longest_edge(mesh), call.max_distance.value_or(kInfinity));
  if (!(last / step < kMostLevels)) {
    refuse_call(fmt::format("\1isolines={}\2: makes more than {} levels up to {:.6g}; give a larger step", step,
                            kMostLevels, last));
  }
  std::vector<double> levels;
  for (int i = 1; i * step <= last; ++i) levels.push_back(i * step);
  return levels;
}

std::vector<Isoline> trace_isolines(const DistancesCall& call, Observer& observer, const Mesh& mesh,
                                    const ExactField& field) {
  const std::vector<double> levels = choose_levels(mesh, field, call);
  try {
    return field.isolines(levels, {.threads = observer.threads, .progress = progress_of(observer)});
  } catch (const Error& error) {
    if (error.code() != ErrorCode::invalid_option) throw;
    if (!call.isolines) refuse_call(fmt::format("\1levels\2: {}", error.text()));
    refuse_call(fmt::format("\1isolines={}\2: {}, with a larger step", *call.isolines, error.text()));
  }
}

constexpr std::size_t kPointsAtOnce = 256;  ///< how many vertices one thread traces before it reports

std::vector<std::array<double, 2>> find_logarithms(Observer& observer, const DistancesOutcome& made) {
  const Mesh& input = made.input->mesh;
  std::vector<std::optional<VertexId>> place(std::size_t(input.vertex_count()));  // the nearest copy of each vertex
  for (const VertexId v : made.surface().vertices()) {
    std::optional<VertexId>& nearest = place[made.parted.input_vertex(v).index()];
    if (!nearest || made.field->distance(v) < made.field->distance(*nearest)) nearest = v;
  }
  return ParallelChunks(observer.threads, progress_of(observer))
      .collect(cut_into_chunks(place.size(), kPointsAtOnce), {"logarithms"}, [&](const Chunk& chunk) {
        std::vector<std::array<double, 2>> found;
        for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
          const VertexId v = place[i].value_or(VertexId());
          Vec2 log = v.valid() ? made.field->departure(vertex_point(made.surface(), v)) : Vec2::Zero();
          const bool is_unknown = !v.valid() || (log.isZero(0) && made.field->distance(v) > 0);
          if (is_unknown) log.setConstant(std::numeric_limits<double>::quiet_NaN());
          found.push_back({log.x(), log.y()});
        }
        return found;
      });
}

/// Computes a single field, for the nearest source.
void measure_nearest(const DistancesCall& call, Observer& observer, DistancesOutcome& made) {
  const Mesh& mesh = made.surface();
  if (call.sources.curves.is_given()) made.curves = choose_curves(*made.input, call.sources, observer);
  for (const GeneratorCurve& curve : made.curves) made.table.sources.push_back(curve.points.front());
  if (!made.curves.empty()) made.table.source_vertices.assign(made.curves.size(), -1);
  made.field = as_step(observer, "distances", [&] {
    const ExactFieldOptions options = field_options(call, observer);
    return made.curves.empty() ? std::make_unique<ExactField>(mesh, made.sources.places, options)
                               : std::make_unique<ExactField>(mesh, made.curves, options);
  });
  add_nearest(made);
  if (call.paths) as_step(observer, "paths", [&] { add_paths(made, *made.field, GeneratorId()); });
  if (call.logarithm) {
    if (made.table.sources.size() != 1) {
      refuse_call(fmt::format("\1logarithm\2 needs exactly one source; {} are given", made.table.sources.size()));
    }
    made.logarithms = as_step(observer, "logarithms", [&] { return find_logarithms(observer, made); });
  }
  if (!call.isolines && !call.levels.is_given()) return;
  made.table.isolines =
      as_step(observer, "isolines", [&] { return trace_isolines(call, observer, mesh, *made.field); });
}

void measure_each(const DistancesCall& call, Observer& observer, DistancesOutcome& made) {
  as_step(observer, "distances", [&] { add_rows(call, observer, made); });
  if (call.paths) as_step(observer, "paths", [&] { add_all_paths(call, observer, made); });
}

/// Refuses a source that has no place on the surface, because all its distances would be infinite.
void check_sources(const DistancesOutcome& made) {
  std::size_t next = 0;
  for (const std::int32_t point : made.sources.point) {
    if (std::size_t(point) > next) break;
    next = std::size_t(point) + 1;
  }
  if (next == made.table.sources.size()) return;
  throw Error(ErrorCode::precondition,
              fmt::format("\1from\2: {} lies in faces that \1within\2 or \1mask\2 leaves out; "
                          "choose another",
                          made.table.source_name(GeneratorId(next))),
              std::int64_t(next));
}

std::int64_t count_levels(const std::vector<Isoline>& lines) {
  std::int64_t count = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) count += i == 0 || lines[i].level != lines[i - 1].level;
  return count;
}

}  // namespace

DistancesCall::DistancesCall() {
  sources.points_name = sources.vertices_name = "\1from\2";
  targets.points_name = targets.vertices_name = "\1to\2";
}

void describe(OptionList& list, DistancesCall& call) {
  list.group("Points");
  list.option("from", PointList{&call.sources.points},
              {.help = "The points to measure from: vertices of the input file, counted from 0, as in 3,17,99",
               .more = fmt::format(", or a file that lists points ({}), or - for standard input",
                                   list_extensions(generator_extensions(), "or")),
               .arrays = "The points to measure from",
               .shown = Shown::main});
  list.option("to", PointList{&call.targets.points},
              {.help = "The points to measure to, as \1from\2 gives them",
               .arrays = "The points to measure to",
               .usual = "all vertices",
               .also = "at",
               .shown = Shown::main});
  list.option("max_snap", Number{&call.sources.max_snap, {.least = 0}},
              {.help = "Refuse a point of a list that is farther than this from the surface", .unit = "mesh units"});
  list.option("merge_coincident", Flag{&call.sources.merge_coincident},
              {.help = "Merge points of \1from\2 that coincide instead of refusing them"});
  list.group("Distances");
  describe_curves(list, call.sources);
  list.option("each", Flag{&call.each}, {.help = "Measure from each source alone, instead of from the nearest one"});
  list.option("paths", Flag{&call.paths},
              {.help = "Trace the shortest path from each point of \1to\2",
               .more = "; .csv then holds the points of the paths",
               .shown = Shown::main});
  list.option("max_distance", Number{&call.max_distance, {.least = 0}},
              {.help = "Stop at this distance", .more = "; farther points are left out", .unit = "mesh units"});
  list.option("isolines", Number{&call.isolines, above(0)},
              {.help = "Trace the curves of equal distance at every multiple of this",
               .unit = "mesh units",
               .shown = Shown::main});
  describe(list, call.regions, "distances and paths");
  list.one_of({{"from", "curves"}, "no sources"});
  list.excludes("curves", {"merge_coincident", "each"});
  list.excludes("curves", {"within", "mask"}, "a curve may leave its region");
  list.excludes("each", {"isolines"}, "isolines are of the nearest source");
  list.rule({"paths", {"to"}, [](const Given& given) -> std::string {
               return given.has("to") ? ""
                                      : "\1paths\2 has no effect here: add \1to\2, where the paths begin, or "
                                        "leave \1paths\2 out";
             }});
}

void describe_for_programs(OptionList& list, DistancesCall& call) {
  list.option("logarithm", Flag{&call.logarithm},
              {.help = "Direction and length of the shortest path to each vertex, in the tangent plane of the source"});
  list.option(
      "levels", ValueSource{&call.levels, {}, ValueSource::Of::generators},
      {.help = "Trace the curves of equal distance at these distances, ascending and above 0", .unit = "mesh units"});
  list.excludes("levels", {"isolines", "each"});
  list.option("keep_coincident", Flag{&call.keep_coincident}, {.help = "With \1each\2, sources may coincide"});
  list.excludes("keep_coincident", {"merge_coincident"});
  list.option(
      "mesh_vertices", Flag{&call.mesh_vertices},
      {.help = "With \1each\2, distances for the mesh's vertices instead of the input's, if repairs changed them"});
  list.excludes("logarithm", {"each", "curves"});
}

std::shared_ptr<const DistancesOutcome> run(const MeshPtr& input, DistancesCall& call, Observer& observer) {
  auto made = std::make_shared<DistancesOutcome>();
  made->asked = asked_of(call);
  made->input = input;
  made->has_limit = call.max_distance.has_value();
  made->has_mesh_vertices = call.mesh_vertices && call.each;
  DistanceTable& table = made->table;
  if (!call.sources.curves.is_given()) {
    const bool may_coincide = call.keep_coincident && call.each;
    ResolvedGenerators sources = may_coincide ? resolve_listed(*input, call.sources, observer, true)
                                              : choose_generators(*input, call.sources, {}, observer);
    table.sources = std::move(sources.points);
    table.source_vertices = std::move(sources.vertex);
    made->snap_distance = std::move(sources.snap_distance);
  }
  if (call.targets.are_listed()) {
    const Step step(observer, "targets");
    call.targets.max_snap = call.sources.max_snap;
    ResolvedGenerators targets = resolve_listed(*input, call.targets, observer, true);
    table.targets = std::move(targets.points);
    table.target_vertices = std::move(targets.vertex);
  }
  PartedMesh& parted = made->parted = find_parted(*input, call.regions, observer);
  separate(input->mesh, parted, observer);
  if (parted.is_parted()) {
    observer.note("inside " + counted(parted.count_regions(), "region", "regions") + describe_left_out(parted));
  }
  made->sources = place_points(input->mesh, parted, table.sources);
  made->targets = place_points(input->mesh, parted, table.targets);
  check_sources(*made);
  call.each ? measure_each(call, observer, *made) : measure_nearest(call, observer, *made);
  made->polylines = make_curves(input->mesh, table);
  made->unreached = std::ranges::count_if(table.rows.values(), [](double d) { return !std::isfinite(d); });
  const bool is_short = !table.targets.empty() && table.rows.size() * table.targets.size() <= kToldDistances;
  if (made->unreached > 0 && !is_short) observer.note(describe_unreached(*made));
  if (call.isolines) {
    observer.note(fmt::format("{} on {}", counted(std::ssize(table.isolines), "isoline", "isolines"),
                              counted(count_levels(table.isolines), "level", "levels")));
  }
  return made;
}

}  // namespace gvd
