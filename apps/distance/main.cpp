// gvd-distance: exact distances on the surface from points of a list, shortest paths, and isolines.
//
// One exact field answers for the nearest source; with --each, each thread computes whole rows, each of one source.
// The distances form a table with a row for each field: of the vertices as the input file numbers them, or of the
// points of --to. Unused vertices of the file are infinitely far; copies of a vertex that was cut count as the nearest
// one. Files hold the table, or the mesh with the distances of its vertices; paths and isolines go where curves fit.
//
// --within and --mask part the surface. A point on the border of regions is in each of them, so it may have several
// places: fields are computed from all places of the sources, and a distance is the least of those of its places.

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "common/barriers.hpp"
#include "common/command.hpp"
#include "common/curves.hpp"
#include "common/options/shared_options.hpp"
#include "common/run_parts.hpp"
#include "distance/measured_surface.hpp"
#include "distance/unreached_points.hpp"
#include "gvd/error.hpp"
#include "gvd/exact_field.hpp"
#include "gvd/io/distance_writer.hpp"
#include "gvd/text.hpp"

namespace gvd::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kExamples =
    "  gvd-distance bunny.obj --from 17 --to 90\n"
    "  gvd-distance bunny.obj --from 17 -o distances.npy\n"
    "  gvd-distance bunny.obj --from 17 --to 90,4000 --paths -o paths.vtp --view a.html\n"
    "  gvd-distance bunny.obj --from seeds.csv --isolines 0.05 -o curves.obj\n"
    "  gvd-distance scan.stl --from seeds.txt --each --max-distance 40 -o rows.npy\n";

/// Notes tell so many distances to points of --to; files and the report have all.
constexpr std::size_t kTold = 8;

/// More levels would fill the memory before anybody could tell them apart.
constexpr double kMostLevels = 10'000;

const std::vector<std::string> kFormats{"npy", "csv", "ply", "vtp", "vtu", "obj", "json", "shape.gii", "curv", "txt"};

struct OwnOptions : Options {
  bool each = false, paths = false;
  std::optional<double> max_distance, isolines;  ///< mesh units
  RegionFiles regions;
};

void describe_points(OptionList& list, OwnOptions& own) {
  list.group("Points");
  describe_list(list, "from", own.generators,
                {.help = "The points to measure from: vertices of the input file, counted from 0, as in 3,17,99",
                 .more = ", or a file that lists points (text, .csv or .json), or - for standard input",
                 .shown = Shown::main});
  describe_list(
      list, "to", own.targets,
      {.help = "The points to measure to, as {option:from} gives them", .usual = "all vertices", .shown = Shown::main});
  list.option("max_snap", Number{&own.generators.max_snap, {.least = 0}},
              {.help = "Refuse a point of a list that is farther than this from the surface", .unit = "mesh units"});
  list.option("merge_coincident", Flag{&own.generators.merge_coincident},
              {.help = "Merge points of {option:from} that are in the same place instead of refusing them"});
}

void describe_distances(OptionList& list, OwnOptions& own) {
  list.group("Distances");
  describe_curves(list, own.generators);
  list.option("each", Flag{&own.each}, {.help = "Measure from each source alone, instead of from the nearest one"});
  list.option("paths", Flag{&own.paths},
              {.help = "Trace the shortest path from each point of {option:to}",
               .more = "; .csv then holds the points of the paths",
               .shown = Shown::main});
  list.option("max_distance", Number{&own.max_distance, {.least = 0}},
              {.help = "Leave out what is farther than this", .more = "; the work ends there", .unit = "mesh units"});
  list.option("isolines", Number{&own.isolines, above(0)},
              {.help = "Trace the curves of equal distance at every multiple of this",
               .unit = "mesh units",
               .shown = Shown::main});
  describe(list, own.regions, "distances and paths");
  list.excludes("curves", {"merge_coincident", "within", "mask"});
}

void describe_own(OptionList& list, OwnOptions& own) {
  own.has_diagram = false;
  own.output.prints = true;
  describe_input(list, own.input);
  describe_points(list, own);
  describe_resources(list, own.compute);
  describe_output(list, own.output, kFormats);
  describe_distances(list, own);
  list.one_of({{"from", "curves"}, "no sources"});
}

/// Where no file is named, standard output has a text that a script reads as it is, or else the simplest format that
/// holds all.
void complete(OwnOptions& own, const Given& given) {
  if (names_file(own.output)) return;
  if (!given.has("output_format")) own.output.formats = {own.isolines ? "json" : own.paths ? "csv" : "txt"};
  own.output.files = {"-"};
}

bool writes(const Options& options, const std::vector<std::string>& formats) {
  const std::vector<std::string> written = written_formats(options.output);
  return std::any_of(written.begin(), written.end(), [&](const std::string& f) { return contains(formats, f); });
}

[[noreturn]] void refuse(const std::string& message) { throw Error(ErrorCode::invalid_option, message); }

/// The file of -o that has this format, for messages.
std::string named(const OutputOptions& output, const std::string& format) {
  for (const std::string& file : output.files) {
    if (file != "-" && format_of(output, file) == format) return "-o " + file;
  }
  return "--output-format " + format;
}

/// Refuses a mesh or a text that would hold nothing of what was asked for.
void check_content(const Options& options, const OwnOptions& own) {
  const OutputOptions& output = options.output;
  const bool has_targets = options.targets.are_listed(), has_curves = own.paths || own.isolines;
  if (!has_curves && writes(options, {"obj"})) {
    refuse(has_targets
               ? fmt::format("{}: .obj holds no distances; add --paths for the shortest paths, or write .csv, .npy or "
                             ".json",
                             named(output, "obj"))
               : fmt::format("{}: .obj holds no distances; write .ply, .vtp, .csv, .npy or .json, or add --isolines",
                             named(output, "obj")));
  }
  const bool holds_targets =
      !output.report.empty() || !output.view.empty() || writes(options, {"npy", "csv", "json", "txt"});
  for (const char* format : {"ply", "vtp", "vtu"}) {
    if (!has_targets || has_curves || holds_targets || !writes(options, {format})) continue;
    refuse(
        fmt::format("{}: .{} has the distances of all vertices, for which --to does nothing; {}write .csv, .npy or "
                    ".json, or leave --to out",
                    named(output, format), format, format == std::string("ply") ? "" : "add --paths, "));
  }
  if (own.paths && !writes(options, {"csv", "json", "obj", "vtp", "vtu"}) && output.report.empty() &&
      output.view.empty()) {
    refuse(
        "--paths: only .csv, .json, .obj, .vtp, .vtu, --view and --report hold paths; write one of them or leave "
        "--paths out");
  }
}

/// Refuses options that contradict each other or have no effect.
void check(const Options& options, const OwnOptions& own) {
  const bool has_targets = options.targets.are_listed(), has_view = !options.output.view.empty();
  if (own.paths && !has_targets)
    refuse("--paths does nothing here: add --to, where the paths begin, or leave --paths out");
  if (own.each && own.isolines) refuse("--each and --isolines exclude each other: isolines are of the nearest source");
  if (own.each && !options.generators.curves.empty()) refuse("--each and --curves exclude each other: keep one");
  if (own.each && has_view) refuse("--each and --view exclude each other: the page shows the nearest source");
  if (own.each && !own.paths && writes(options, {"ply", "vtp", "vtu", "obj"})) {
    refuse(
        "--each: .ply, .vtp, .vtu and .obj hold one distance for each vertex; write .npy, .csv or .json, or add --to "
        "and "
        "--paths");
  }
  if (has_targets && writes(options, {"shape.gii", "curv"})) {
    refuse("--to: .shape.gii and .curv hold a distance for each vertex; write .npy, .csv or .json, or leave --to out");
  }
  if (own.each && writes(options, {"curv"})) {
    refuse("--each: .curv holds one distance for each vertex; write .shape.gii, .npy, .csv or .json");
  }
  const bool holds_curves =
      has_view || !options.output.report.empty() || writes(options, {"obj", "vtp", "vtu", "json"});
  if (own.isolines && !holds_curves) {
    refuse(
        "--isolines: only .obj, .vtp, .vtu, .json, --view and --report hold curves; write one of them or leave "
        "--isolines "
        "out");
  }
  check_content(options, own);
}

ExactFieldOptions field_options(Run& run, const OwnOptions& own) {
  ExactFieldOptions options;
  options.threads = run.options().compute.diagram.threads;
  options.progress = run.progress();
  options.max_distance = own.max_distance.value_or(kInfinity);
  return options;
}

/// Calls take(i, v) for each vertex i of the file and each vertex v of the mesh that it became: several where one was
/// cut, and the same one for several that were welded.
template <class Take>
void match_vertices(const CheckedMesh& input, const Take& take) {
  for (std::size_t i = 0; i < input.mesh_vertex.size(); ++i) {
    if (input.mesh_vertex[i].valid()) take(i, input.mesh_vertex[i]);
  }
  for (const VertexId v : input.mesh.vertices()) {
    if (input.input_vertex[v] >= 0) take(std::size_t(input.input_vertex[v]), v);
  }
}

/// The measured surface, and where the points of the lists are on it.
struct Measurement {
  const CheckedMesh& input;
  const MeasuredSurface& surface;
  PlacedPoints sources, targets;

  /// The source of a field from all places of the sources.
  GeneratorId source(GeneratorId place) const {
    return place.valid() && !sources.point.empty() ? GeneratorId(sources.point[place.index()]) : place;
  }
};

/// Nearest sources of points, and their distances.
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

/// The nearest source of each vertex of the input's mesh, which may be at several places of the surface.
NearestSources find_nearest_of_vertices(const Measurement& measured, const ExactField& field) {
  NearestSources found(std::size_t(measured.input.mesh.vertex_count()));
  for (const VertexId v : measured.surface.mesh().vertices()) {
    found.take(measured.surface.input_vertex(v).index(), field.distance(v), measured.source(field.label(v)));
  }
  return found;
}

/// Adds the distances of a field in the order of the table's points, and the nearest sources. `vertices`: those of the
/// mesh's vertices.
void add_nearest(DistanceTable& table, const Measurement& measured, const ExactField& field,
                 const NearestSources& vertices) {
  const CheckedMesh& input = measured.input;
  NearestSources found(table.targets.empty() ? input.mesh_vertex.size() : table.targets.size());
  for (std::size_t i = 0; i < measured.targets.places.size(); ++i) {
    const ExactField::Nearest nearest = field.nearest(measured.targets.places[i]);
    found.take(std::size_t(measured.targets.point[i]), nearest.distance, measured.source(nearest.generator));
  }
  if (table.targets.empty()) {
    match_vertices(input, [&](std::size_t i, VertexId v) {
      found.take(i, vertices.distance[v.index()], vertices.source[v.index()]);
    });
  }
  table.rows.push_back(std::move(found.distance));
  table.nearest = std::move(found.source);
}

/// Sources whose rows are computed at once: enough for all cores, and little beside the table.
constexpr std::size_t kSourcesAtOnce = 64;

/// The part of the machine's memory that a table may take: it is computed and written beside other things.
constexpr double kMemoryShare = 0.5;

/// Refuses a table that the memory does not hold, before the work.
void check_table(const Options& options, std::size_t sources, std::size_t points) {
  const double machine = kMemoryShare * double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGE_SIZE));
  const double most = std::min(machine, double(options.compute.max_memory.value_or(INT64_MAX)));
  const double needed = double(sources) * double(points) * sizeof(double);
  if (needed <= most) return;
  refuse(
      fmt::format("--each: {} sources and {} points make a table of {:.3g} GB, and at most {:.3g} GB fit; give fewer "
                  "sources, or --to; Python's distance_rows computes row by row",
                  sources, points, needed / 1e9, most / 1e9));
}

/// A row of distances from each source.
void add_rows(Run& run, const OwnOptions& own, const Measurement& measured, DistanceTable& table) {
  const CheckedMesh& input = measured.input;
  const Mesh& mesh = measured.surface.mesh();
  const bool has_targets = !table.targets.empty();
  const std::vector<SurfacePoint>& sources = measured.sources.places;
  const std::size_t places = has_targets ? measured.targets.places.size() : std::size_t(mesh.vertex_count());
  const std::size_t points = has_targets ? table.targets.size() : input.mesh_vertex.size();
  check_table(run.options(), table.sources.size(), points);
  table.rows.assign(table.sources.size(), std::vector<double>(points, kInfinity));
  if (places == 0) return;  // all targets are left out
  ExactFieldOptions options = field_options(run, own);
  std::vector<double> rows, of_vertices;
  for (std::size_t begin = 0; begin < sources.size(); begin += kSourcesAtOnce) {
    const std::size_t end = std::min(begin + kSourcesAtOnce, sources.size());
    rows.resize((end - begin) * places);
    options.progress = [&, shown = run.progress()](std::string_view step, double done) {
      return shown(step, (double(begin) + done * double(end - begin)) / double(sources.size()));
    };
    compute_distance_rows(mesh, {sources.begin() + begin, sources.begin() + end},
                          has_targets ? &measured.targets.places : nullptr, rows, options);
    for (std::size_t source = begin; source < end; ++source) {
      const auto first = rows.begin() + std::ptrdiff_t((source - begin) * places);
      std::vector<double>& row = table.rows[std::size_t(measured.sources.point[source])];
      const auto take = [&](std::size_t i, double d) { row[i] = std::min(row[i], d); };
      if (has_targets) {
        for (std::size_t k = 0; k < places; ++k) take(std::size_t(measured.targets.point[k]), first[k]);
        continue;
      }
      of_vertices.assign(std::size_t(input.mesh.vertex_count()), kInfinity);
      for (const VertexId v : mesh.vertices()) {
        double& least = of_vertices[measured.surface.input_vertex(v).index()];
        least = std::min(least, first[v.index()]);
      }
      match_vertices(input, [&](std::size_t i, VertexId v) { take(i, of_vertices[v.index()]); });
    }
  }
}

/// Adds a path from each target, out of its nearest place. `only`: the source, where the field is of that one alone.
void add_paths(DistanceTable& table, const Measurement& measured, const ExactField& field, GeneratorId only) {
  std::vector<std::optional<SurfacePoint>> starts(table.targets.size());
  std::vector<double> least(table.targets.size(), kInfinity);
  for (std::size_t k = 0; k < measured.targets.places.size(); ++k) {
    const std::size_t target = std::size_t(measured.targets.point[k]);
    const double d = field.nearest(measured.targets.places[k]).distance;
    if (!(d < least[target])) continue;
    least[target] = d;
    starts[target] = measured.targets.places[k];
  }
  for (std::size_t i = 0; i < table.targets.size(); ++i) {
    GeodesicPath path{.points = {}, .generator = {}, .length = kInfinity};
    if (starts[i]) path = field.path(*starts[i]);
    const GeneratorId source = only.valid() && path.generator.valid() ? only : measured.source(path.generator);
    TargetPath& added = table.paths.emplace_back(TargetPath{std::int32_t(i), source, std::move(path)});
    for (const SurfacePoint& point : added.path.points) {
      added.positions.push_back(position(measured.surface.mesh(), point));
    }
  }
}

std::vector<double> choose_levels(const Mesh& mesh, const ExactField& field, const OwnOptions& own) {
  double largest = 0;
  for (const VertexId v : mesh.vertices()) {
    if (std::isfinite(field.distance(v))) largest = std::max(largest, field.distance(v));
  }
  // No point of a face is farther from its vertices than its longest edge.
  const double step = *own.isolines;
  const double last = std::min(largest + longest_edge(mesh), own.max_distance.value_or(kInfinity));
  if (!(last / step < kMostLevels)) {
    refuse(fmt::format("--isolines {}: makes more than {} levels up to {:.6g}; give a larger step", step, kMostLevels,
                       last));
  }
  std::vector<double> levels;
  for (int i = 1; i * step <= last; ++i) levels.push_back(i * step);
  return levels;
}

std::vector<Isoline> trace_isolines(Run& run, const OwnOptions& own, const Mesh& mesh, const ExactField& field) {
  const std::vector<double> levels = choose_levels(mesh, field, own);
  try {
    return field.isolines(levels, {.threads = run.options().compute.diagram.threads, .progress = run.progress()});
  } catch (const Error& error) {
    if (error.code() != ErrorCode::invalid_option) throw;
    refuse(fmt::format("--isolines {}: {}, with a larger step", *own.isolines, error.what()));
  }
}

double length_of(const Mesh& mesh, const Isoline& line) {
  double length = 0;
  for (std::size_t i = line.closed ? 0 : 1; i < line.points.size(); ++i) {
    const SurfacePoint& before = i > 0 ? line.points[i - 1] : line.points.back();
    length += (position(mesh, line.points[i]) - position(mesh, before)).norm();
  }
  return length;
}

Json describe_isolines(const Mesh& mesh, const std::vector<Isoline>& lines) {
  Json levels = Json::array();
  for (const Isoline& line : lines) {
    if (levels.empty() || levels.back()["level"] != line.level) {
      levels.push_back({{"level", line.level}, {"curves", 0}, {"closed", 0}, {"length", 0.0}});
    }
    Json& level = levels.back();
    level["curves"] = level["curves"].get<int>() + 1;
    level["closed"] = level["closed"].get<int>() + (line.closed ? 1 : 0);
    level["length"] = level["length"].get<double>() + length_of(mesh, line);
  }
  return levels;
}

Json describe_targets(const Mesh& mesh, const DistanceTable& table) {
  Json targets = Json::array();
  for (std::size_t i = 0; i < table.targets.size(); ++i) {
    const Vec3 p = position(mesh, table.targets[i]);
    const std::int64_t vertex = table.target_vertex(i);
    Json& target = targets.emplace_back(Json{{"vertex", vertex < 0 ? Json() : Json(vertex)},
                                             {"face", table.targets[i].face.value()},
                                             {"bary", table.targets[i].bary},
                                             {"position", {p.x(), p.y(), p.z()}},
                                             {"distances", Json::array()}});
    for (const std::vector<double>& row : table.rows) {
      target["distances"].push_back(std::isfinite(row[i]) ? Json(row[i]) : Json());
    }
    target["source"] = table.nearest.empty() ? Json() : Json(table.nearest[i].value());
  }
  return targets;
}

/// Notes the first distances to the points of --to. Returns whether these are all distances.
bool note_targets(Run& run, const DistanceTable& table, UnreachedPoints& unreached) {
  if (table.targets.empty() || contains(run.options().output.files, "-")) return false;  // they are on standard output
  std::size_t told = 0;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    for (std::size_t i = 0; i < table.targets.size() && told < kTold; ++i, ++told) {
      const double distance = table.rows[row][i];
      const std::string target = table.target_name(i);
      run.console().note(
          std::isfinite(distance)
              ? fmt::format("{} is {:.9g} from {}", target, distance, table.source_name(table.source(row, i)))
              : fmt::format("{} is not reached from {}: it is {}", target,
                            table.nearest.empty() ? table.source_name(GeneratorId(row)) : "any source",
                            describe(unreached.find(row, i), unreached.inside())));
    }
  }
  const std::size_t all = table.rows.size() * table.targets.size();
  if (told < all) run.console().note(fmt::format("... and {} more", all - told));
  return told == all;
}

/// Notes how many distances are infinite, and why. Returns their number.
std::int64_t note_unreached(Run& run, const DistanceTable& table, UnreachedPoints& unreached, bool are_told) {
  std::int64_t count = 0, sum = 0;
  BarrierCounts barriers;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    for (std::size_t i = 0; i < table.rows[row].size(); ++i) {
      ++count;
      if (std::isfinite(table.rows[row][i])) continue;
      ++sum;
      barriers.add(unreached.find(row, i));
    }
  }
  if (sum > 0 && !are_told) {
    run.console().note(fmt::format("{} of {}{} {} inf: {}", sum, counted(count, "distance", "distances"),
                                   table.targets.empty() ? " to vertices" : "",
                                   table.targets.empty() || sum > 1 ? "are" : "is",
                                   barriers.describe(unreached.inside())));
  }
  return sum;
}

void report_table(Run& run, const OwnOptions& own, const Measurement& measured, const DistanceTable& table) {
  double largest = 0;
  for (const std::vector<double>& row : table.rows) {
    for (const double d : row) {
      if (std::isfinite(d)) largest = std::max(largest, d);
    }
  }
  UnreachedPoints unreached(measured.input, measured.surface, table, measured.targets, own.max_distance.has_value());
  const bool are_told = note_targets(run, table, unreached);
  Json& results = run.report().results();
  results["sources"] = table.sources.size();
  results["source_vertices"] = Json::array();
  for (std::size_t i = 0; i < table.sources.size(); ++i) {
    const std::int64_t vertex = table.source_vertex(GeneratorId(i));
    results["source_vertices"].push_back(vertex < 0 ? Json() : Json(vertex));
  }
  results["distances"] = table.rows.size() * (table.rows.empty() ? 0 : table.rows.front().size());
  results["unreached"] = note_unreached(run, table, unreached, are_told);
  results["largest"] = largest;
  results["targets"] = describe_targets(measured.input.mesh, table);
  Json& paths = results["paths"] = Json::array();
  for (const auto& [target, source, path, positions] : table.paths) {
    paths.push_back({{"source", source.value()},
                     {"target", target},
                     {"length", std::isfinite(path.length) ? Json(path.length) : Json()},
                     {"points", path.points.size()},
                     {"complete", path.complete}});
  }
  results["isolines"] = describe_isolines(measured.input.mesh, table.isolines);
  if (own.isolines) {
    run.console().note(fmt::format("{} on {}", counted(std::ssize(table.isolines), "isoline", "isolines"),
                                   counted(std::ssize(results["isolines"]), "level", "levels")));
  }
}

void write_files(Run& run, const CheckedMesh& input, const DistanceTable& table, LabelledMesh output) {
  const Mesh& mesh = input.mesh;
  output.appearance = &input.appearance;
  const bool has_paths = !table.paths.empty();
  const std::vector<MeshCurve> curves = make_curves(mesh, table);
  if (!curves.empty()) output.curves = &curves;
  write_output_files(
      run, output,
      {{"npy", [&](std::ostream& out) { write_distances_npy(out, table); }},
       {"txt", [&](std::ostream& out) { write_distances_text(out, table); }},
       {"csv", [&](std::ostream& out) { has_paths ? write_paths_csv(out, table) : write_distances_csv(out, table); }},
       {"json", [&](std::ostream& out) { write_distances_json(out, mesh, table); }},
       {"shape.gii", [&](std::ostream& out) { write_distances_gifti(out, table); }},
       {"curv", [&](std::ostream& out) { write_distances_freesurfer(out, table, mesh.face_count()); }}});
}

/// One field for the nearest source.
void measure_nearest(Run& run, const OwnOptions& own, const Measurement& measured, DistanceTable& table) {
  const Mesh &input = measured.input.mesh, &mesh = measured.surface.mesh();
  const bool has_curves = !run.options().generators.curves.empty();
  const std::vector<GeneratorCurve> curves =
      has_curves ? load_curves(run, measured.input) : std::vector<GeneratorCurve>();
  for (const GeneratorCurve& curve : curves) table.sources.push_back(curve.points.front());
  if (has_curves) table.source_vertices.assign(curves.size(), -1);
  const ExactField field = run.timed("distances", [&] {
    const ExactFieldOptions options = field_options(run, own);
    return has_curves ? ExactField(mesh, curves, options) : ExactField(mesh, measured.sources.places, options);
  });
  const NearestSources vertices = find_nearest_of_vertices(measured, field);
  add_nearest(table, measured, field, vertices);
  if (own.paths) run.timed("paths", [&] { add_paths(table, measured, field, GeneratorId()); });
  if (own.isolines) table.isolines = run.timed("isolines", [&] { return trace_isolines(run, own, mesh, field); });
  report_table(run, own, measured, table);
  IdVector<VertexId, double> distances;
  IdVector<VertexId, GeneratorId> labels;
  for (const double d : vertices.distance) distances.push_back(d);
  for (const GeneratorId source : vertices.source) labels.push_back(source);
  write_files(run, measured.input, table, {.mesh = input, .vertex_label = &labels, .vertex_distance = &distances});
  write_view_file(run, "gvd-distance", [&] {
    std::vector scenes{make_distance_scene("Distances", mesh, field, table)};
    for (const GeneratorCurve& curve : curves) {
      for (auto& line : polylines(mesh, curve)) scenes[0].paths.push_back(std::move(line));
    }
    return scenes;
  });
}

/// The paths from all targets to each source.
void add_all_paths(Run& run, const OwnOptions& own, const Measurement& measured, DistanceTable& table) {
  ExactFieldOptions options = field_options(run, own);
  const PlacedPoints& sources = measured.sources;
  for (std::size_t i = 0, begin = 0; i < table.sources.size(); ++i) {
    options.progress = [&, shown = run.progress()](std::string_view, double done) {
      return shown("paths", (double(i) + done) / double(table.sources.size()));
    };
    std::vector<SurfacePoint> places;
    for (; begin < sources.places.size() && sources.point[begin] == std::int32_t(i); ++begin) {
      places.push_back(sources.places[begin]);
    }
    add_paths(table, measured, ExactField(measured.surface.mesh(), places, options), GeneratorId(i));
  }
}

void measure_each(Run& run, const OwnOptions& own, const Measurement& measured, DistanceTable& table) {
  const CheckedMesh& input = measured.input;
  run.timed("distances", [&] { add_rows(run, own, measured, table); });
  if (own.paths) run.timed("paths", [&] { add_all_paths(run, own, measured, table); });
  report_table(run, own, measured, table);
  write_files(run, input, table, {.mesh = input.mesh});
}

/// Refuses a source that is nowhere on the surface: its distances would all be infinite.
void check_sources(const DistanceTable& table, const PlacedPoints& placed) {
  std::size_t next = 0;
  for (const std::int32_t point : placed.point) {
    if (std::size_t(point) > next) break;
    next = std::size_t(point) + 1;
  }
  if (next == table.sources.size()) return;
  throw Error(ErrorCode::precondition,
              fmt::format("--from: {} lies in faces that --within or --mask leaves out; choose another",
                          table.source_name(GeneratorId(next))),
              std::int64_t(next));
}

void measure(Run& run, OwnOptions& own) {
  check(run.options(), own);
  const CheckedMesh input = load_input(run);
  DistanceTable table;
  if (run.options().generators.curves.empty()) {
    ListedPoints sources = load_sources(run, input);
    table.sources = std::move(sources.points);
    table.source_vertices = std::move(sources.vertices);
  }
  ListedPoints targets = load_targets(run, input);
  table.targets = std::move(targets.points);
  table.target_vertices = std::move(targets.vertices);
  const MeasuredSurface surface(run, input, own.regions);
  const Measurement measured{input, surface, surface.place(table.sources), surface.place(table.targets)};
  check_sources(table, measured.sources);
  own.each ? measure_each(run, own, measured, table) : measure_nearest(run, own, measured, table);
  write_report(run);
}

}  // namespace

Command distance_command() {
  return make_command<OwnOptions>(
      {"gvd-distance",
       "Measures exact distances on a triangle mesh from given points, with shortest paths and isolines.",
       kExamples,
       {kFormats, false}},
      {describe_own, measure, complete});
}

}  // namespace gvd::app
