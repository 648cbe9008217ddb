// Runs of the command gvd-remesh, and the figures of its results.
//
// Figures come from the command's own report (docs/schema) where it has them, and from the written mesh otherwise: so
// they are what a user gets. The command reports wall-clock times of its steps, in whose proportions its processor time
// is divided. A crease of the input is kept where one of the result runs beside it, within 0.5 % of the diagonal and 20
// degrees; with shorter distances a crease that is approximated by longer edges would count as lost.
#include "remesh_run.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <regex>
#include <string_view>
#include <vector>

#include "clocks.hpp"
#include "gvd/creases.hpp"
#include "gvd/quality.hpp"
#include "gvd/read_soup.hpp"
#include "gvd/soup.hpp"

namespace gvd::bench {

namespace {

struct Segment {
  Vec3 a, b;
};

/// The edges at which the normals of the two faces differ by more than an angle, degrees.
std::vector<Segment> crease_segments(const Mesh& mesh, double angle) {
  std::vector<Segment> segments;
  for (const EdgeId e : find_creases(mesh, {angle, false})) {
    const HalfedgeId h = mesh.halfedge(e);
    segments.push_back({mesh.position(mesh.from(h)), mesh.position(mesh.to(h))});
  }
  return segments;
}

double squared_distance(const Vec3& p, const Segment& s) {
  const Vec3 along = s.b - s.a;
  const double t = std::clamp((p - s.a).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (s.a + t * along - p).squaredNorm();
}

}  // namespace

double percent_of_creases_kept(const Mesh& input, const Mesh& remesh, const KeptCreaseOptions& options) {
  const std::vector<Segment> candidates = crease_segments(remesh, options.angle);
  const double reach = std::pow(options.distance * input.bbox_diagonal(), 2);
  const double least_cosine = std::cos(options.direction * std::numbers::pi / 180);
  double all = 0, kept = 0;
  for (const Segment& edge : crease_segments(input, options.angle)) {
    const Vec3 middle = 0.5 * (edge.a + edge.b), direction = (edge.b - edge.a).normalized();
    const double length = (edge.b - edge.a).norm();
    all += length;
    const bool is_kept = std::any_of(candidates.begin(), candidates.end(), [&](const Segment& other) {
      return squared_distance(middle, other) <= reach &&
             std::abs((other.b - other.a).normalized().dot(direction)) >= least_cosine;
    });
    if (is_kept) kept += length;
  }
  return all > 0 ? 100 * kept / all : 100;
}

namespace {

/// A folder of this process that is gone at the end.
class Scratch {
 public:
  Scratch() : path_(std::filesystem::temp_directory_path() / fmt::format("gvd-bench-remesh-{}", getpid())) {
    std::filesystem::create_directories(path_);
  }
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  std::string file(const char* name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

/// Processor time of all commands that this process has run to their end.
double seconds_of_children() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// For the shell.
std::string quoted(const std::string& text) {
  return fmt::format("'{}'", std::regex_replace(text, std::regex("'"), "'\\''"));
}

std::string command_line(const RemeshRequest& request, const std::string& output, const std::string& report) {
  const std::string features = request.features ? fmt::format("--features {}", *request.features) : "";
  return fmt::format("{} {} -n {} {} --threads 1 --quiet -o {} --report {} 2>/dev/null", quoted(GVD_REMESH_COMMAND),
                     quoted(request.path), request.vertices, features, quoted(output), quoted(report));
}

/// The steps that make the mesh: others read, measure and write.
bool makes_mesh(std::string_view step) {
  return step == "relaxation" || step == "diagram" || step == "dual" || step == "placement" || step == "search";
}

/// Steps are reported in wall-clock time; their shares are taken of the processor time.
void divide_time(const nlohmann::json& timings, RemeshFigures& figures) {
  double all = 0, made = 0;
  for (const auto& [step, milliseconds] : timings.items()) {
    all += milliseconds.get<double>();
    if (makes_mesh(step)) made += milliseconds.get<double>();
  }
  if (all > 0) figures.made_seconds = figures.seconds * made / all;
  if (made > 0) figures.diagrams = 100 * timings.value("diagram", 0.0) / made;
}

/// The figures that the command reports itself. Of the two directions of a distance the larger one counts.
void read_report(const nlohmann::json& report, RemeshFigures& figures) {
  const nlohmann::json& results = report.at("results");
  const nlohmann::json& distance = results.at("distance");
  const auto percent = [&](const char* kind) {
    const double larger = std::max(distance.at("input_to_output").at(kind).get<double>(),
                                   distance.at("output_to_input").at(kind).get<double>());
    return 100 * larger / report.at("input").at("bbox_diagonal").get<double>();
  };
  figures.hausdorff = percent("hausdorff");
  figures.rms = percent("rms");
  const nlohmann::json& quality = results.at("quality").at("output");
  figures.q = quality.at("q_average").get<double>();
  figures.least_angle = quality.at("angle_min").get<double>();
  figures.below_30 = quality.at("percent_below_30").get<double>();
  figures.intersections = results.at("certificate").at("self_intersections").get<double>();
  figures.rounds = results.at("rounds").get<double>();
  divide_time(report.at("timings_ms"), figures);
}

/// Degrees; 60 for equilateral triangles alone.
double median_smallest_angle(const Mesh& mesh) {
  std::vector<double> angles;
  for (const FaceId f : mesh.faces()) {
    const auto& [a, b, c] = mesh.vertices(f);
    angles.push_back(compute_min_angle(mesh.position(a), mesh.position(b), mesh.position(c)));
  }
  return angles.empty() ? 0 : median(angles);
}

/// Whether two meshes have the same Euler characteristic, components and boundary loops.
bool same_topology(const Mesh& a, const Mesh& b) {
  const MeshSummary x = compute_mesh_summary(a), y = compute_mesh_summary(b);
  return x.euler_characteristic == y.euler_characteristic && x.components == y.components &&
         x.boundary_loops == y.boundary_loops;
}

}  // namespace

std::optional<RemeshFigures> run_remesh(const Mesh& input, const RemeshRequest& request) {
  const Scratch scratch;
  const std::string output = scratch.file("out.ply"), report = scratch.file("report.json");
  const double start = seconds_of_children();
  if (std::system(command_line(request, output, report).c_str()) != 0) return std::nullopt;
  RemeshFigures figures;
  figures.seconds = seconds_of_children() - start;
  std::ifstream in(report);
  read_report(nlohmann::json::parse(in), figures);
  const Mesh mesh = build_mesh(read_soup(output)).mesh;
  figures.right_topology = same_topology(input, mesh);
  figures.inflation = double(mesh.vertex_count()) / request.vertices;
  figures.angle = median_smallest_angle(mesh);
  figures.creases_kept = percent_of_creases_kept(input, mesh);
  return figures;
}

}  // namespace gvd::bench
