#include "remesh_run.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "gvd/quality.hpp"
#include "gvd/soup.hpp"
#include "kept_creases.hpp"
#include "median.hpp"

namespace gvd::bench {
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

double seconds_of_children() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// For the shell.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'') {
      result += "'\\''";
    } else {
      result += c;
    }
  }
  result += "'";
  return result;
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

void divide_time(const nlohmann::json& timings, RemeshFigures& figures) {
  double all = 0, made = 0;
  for (const auto& [step, milliseconds] : timings.items()) {
    all += milliseconds.get<double>();
    if (makes_mesh(step)) made += milliseconds.get<double>();
  }
  if (all > 0) figures.made_seconds = figures.seconds * made / all;
  if (made > 0) figures.diagrams = 100 * timings.value("diagram", 0.0) / made;
}

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
  figures.q = results.at("quality").at("output").at("q_average").get<double>();
  figures.rounds = results.at("rounds").get<double>();
  divide_time(report.at("timings_ms"), figures);
}

double median_smallest_angle(const Mesh& mesh) {
  std::vector<double> angles;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto& [a, b, c] = mesh.vertices(FaceId(f));
    angles.push_back(compute_min_angle(mesh.position(a), mesh.position(b), mesh.position(c)));
  }
  return angles.empty() ? 0 : median(angles);
}

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
  figures.inflation = static_cast<double>(mesh.vertex_count()) / request.vertices;
  figures.angle = median_smallest_angle(mesh);
  figures.kept = percent_of_creases_kept(input, mesh);
  return figures;
}

}  // namespace gvd::bench
