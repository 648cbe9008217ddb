// The whole pipeline on random soups with random generators: every result is sound, or one gvd::Error says why there is
// none. Each crash or finding becomes a regression in the area of its cause.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <string_view>

#include "fuzz/findings.hpp"
#include "fuzz/random_points.hpp"
#include "fuzz/random_soup.hpp"
#include "geodesic/windows/face_frames.hpp"
#include "gvd/lloyd.hpp"
#include "gvd/read_soup.hpp"
#include "gvd/remesh.hpp"
#include "gvd/remesh_map.hpp"
#include "gvd/soup.hpp"
#include "support/catch.hpp"
#include "support/environment.hpp"
#include "support/same_diagram.hpp"
#include "support/sanitized.hpp"

namespace gvd::test_pipeline {

using test::Findings;
using test::Random;

/// Seeds of the ordinary test, which takes a few seconds, and most of a minute with sanitizers.
constexpr unsigned kFirstSeed = 401, kSeeds = test::kSanitized ? 100 : 300;

/// A step on these small meshes reports progress a few times at most (once in 16,384 windows). A diagram has up to 13
/// rounds of three steps. One with more reports than this does not terminate. A limit on time would depend on the
/// machine.
constexpr int kMaxReports = 120;

/// The same for a remesh or a relaxation, where one step consists of several diagrams.
constexpr int kMaxReportsOfMany = 40 * kMaxReports;

/// Distances are compared for at most this many generators: each one needs an exact field, evaluated at every crossing.
constexpr std::size_t kMaxFields = 12;

struct Counts {
  int meshes = 0, refused = 0, diagrams = 0, coincident = 0, remeshes = 0, without_remesh = 0, one_to_one = 0,
      relaxed = 0;
  int close = 0, welded = 0;  ///< with generators that nearly coincide
  int uncut = 0;              ///< diagrams that cutting refuses, as it may
};

constexpr std::array kMethods{Method::exact, Method::gbgvd, Method{Solver::windows, Tracer::growth},
                              Method{Solver::fast_marching, Tracer::envelope}};

/// Cancels a step that does not terminate.
Progress limited(int maximum = kMaxReports) {
  return [reports = 0, maximum](std::string_view, double fraction) mutable {
    reports = fraction == 0 ? 0 : reports + 1;
    return reports <= maximum;
  };
}

class FuzzCase {
 public:
  FuzzCase(unsigned seed, Counts& counts) : random_(seed), counts_(counts) {}

  /// Reads, repairs, and runs everything.
  void run() {
    const test::RandomSoup soup = test::make_random_soup(random_);
    obj_ = test::write_obj(soup);
    name_ = soup.name;
    CheckedMesh checked;
    if (!attempt("read", [&] { checked = build_mesh(parse_soup(obj_, MeshFormat::obj, "soup.obj")); })) {
      ++counts_.refused;
      return;
    }
    ++counts_.meshes;
    const test::RandomPoints chosen = test::make_random_points(checked.mesh, random_);
    points_ = chosen.points;
    name_ += ", generators " + chosen.name;
    const bool all = std::getenv("GVD_FUZZ_ALL") != nullptr;
    are_close_ = !all && test::are_close(checked.mesh, points_, test::kClose);
    are_welded_ = !all && test::are_close(checked.mesh, points_, test::kWelded);
    has_thin_faces_ = !all && FaceFrames(checked.mesh, ParallelChunks(1, {})).has_thin_faces;
    counts_.close += are_close_;
    counts_.welded += are_welded_;
    run_on(checked.mesh);
  }

  const Findings& findings() const { return findings_; }
  /// The mesh and the generators, to be put into a file.
  std::string describe() const {
    std::string text = "# " + name_ + "\n" + obj_ + "# generators on the repaired mesh:\n";
    for (const SurfacePoint& p : points_) {
      text += fmt::format("# F {} {} {} {}\n", p.face.value(), p.bary[0], p.bary[1], p.bary[2]);
    }
    return text;
  }

 private:
  void run_on(const Mesh& mesh) {
    DiagramOptions options;
    options.chord_tolerance = random_.below(2) == 0 ? 1e-4 : std::pow(10, random_.real(-6, -1));
    options.front = random_.below(2) == 0 ? Front::circle : Front::planar;
    for (const Method& method : kMethods) {
      options.method = method;
      if (!run_method(mesh, options)) return;
    }
    options.method = Method::exact;
    options.chord_tolerance = 1e-3;
    switch (random_.below(4)) {
      case 0:
        return run_remesh(mesh, options);
      case 1:
        return run_relaxation(mesh, options);
    }
  }

  /// False if generators coincide. Then every method must say so, and nothing else can be tested.
  bool run_method(const Mesh& mesh, DiagramOptions options) {
    Diagram diagram, again;
    const bool done = attempt("diagram", [&] {
      options.progress = limited();
      diagram = compute_diagram(mesh, points_, options);
      options.progress = limited();
      again = compute_diagram(mesh, points_, options);
    });
    if (!done) {
      ++counts_.coincident;
      if (last_error_.find("coincide") == std::string::npos) add("diagram", {"refused: " + last_error_});
      return false;
    }
    ++counts_.diagrams;
    const std::string step = fmt::format("diagram {}{}", options.method.solver == Solver::windows ? "exact" : "marched",
                                         options.method.tracer == Tracer::envelope ? "" : " grown");
    add_sound(step, test::examine(mesh, diagram));
    if (!test::same_diagram(diagram, again)) add(step, {"two runs differ"});
    if (!findings_.empty()) return true;
    if (!attempt(step, [&] { add(step, test::examine_segmentation(mesh, diagram)); })) add(step, {last_error_});
    // Marched distances are not the metric of any surface: refined arcs may cross, and pieces overlap.
    const bool is_marched = options.method.solver == Solver::fast_marching && options.method.tracer == Tracer::envelope;
    if (!is_marched) run_cut(step, mesh, diagram);
    if (options.method != Method::exact || points_.size() > kMaxFields) return true;
    const test::Compare compare = are_close_ ? test::Compare::distances : test::Compare::all;
    if (!attempt(step, [&] { add(step, test::examine_distances(mesh, diagram, compare)); })) add(step, {last_error_});
    return true;
  }

  /// Where cells are too narrow for it, cutting may find no manifold mesh. What it does find must be right.
  void run_cut(const std::string& step, const Mesh& mesh, const Diagram& diagram) {
    if (attempt(step, [&] { add(step, test::examine_cut(mesh, diagram)); })) return;
    const bool may_refuse = (are_welded_ || has_thin_faces_) && last_code_ == ErrorCode::no_valid_result;
    counts_.uncut += may_refuse;
    if (!may_refuse) add(step, {last_error_});
  }

  void run_remesh(const Mesh& mesh, const DiagramOptions& diagram) {
    RemeshOptions options;
    options.diagram = diagram;
    options.diagram.progress = limited(kMaxReportsOfMany);
    options.max_added = 20;
    RemeshResult result;
    if (attempt("remesh", [&] { result = remesh(mesh, points_, options); })) {
      ++counts_.remeshes;
      if (!result.certificate.ok()) add("remesh", {result.certificate.first_failure()});
      add("remesh", test::examine(mesh, result.diagram));
      run_map(mesh, result);
    } else {
      ++counts_.without_remesh;
    }
  }

  /// Where faces have nearly no area, the map may turn one round in the plane. Then it must say so.
  void run_map(const Mesh& mesh, const RemeshResult& result) {
    RemeshMap map;
    if (!attempt("map", [&] { map = map_to_remesh(mesh, result, 1); })) return add("map", {"refused: " + last_error_});
    counts_.one_to_one += map.one_to_one;
    if (map.one_to_one != map.obstacle.empty()) add("map", {"one-to-one with an obstacle, or not and without one"});
    const auto is_point = [](const SurfacePoint& point, const Mesh& on) {
      const auto& [a, b, c] = point.bary;
      const bool in_range = point.face.valid() && point.face.value() < on.face_count();
      return in_range && a >= 0 && b >= 0 && c >= 0 && std::abs(a + b + c - 1) < 1e-12;
    };
    for (const SurfacePoint& point : map.points) {
      if (!is_point(point, result.mesh)) return add("map", {"a vertex of the surface has no point"});
    }
    for (const SurfacePoint& point : map.origins) {
      if (!is_point(point, mesh)) return add("map", {"a vertex of the remesh has no origin"});
    }
  }

  void run_relaxation(const Mesh& mesh, const DiagramOptions& diagram) {
    LloydOptions options;
    options.diagram = diagram;
    options.progress = limited(kMaxReportsOfMany);
    options.max_iterations = 2;
    LloydResult result;
    if (!attempt("relaxation", [&] { result = relax_generators(mesh, points_, options); })) {
      return add("relaxation", {"refused: " + last_error_});
    }
    ++counts_.relaxed;
    add("relaxation", test::examine(mesh, result.diagram));
    double energy = result.initial_energy;
    for (const LloydIteration& iteration : result.iterations) {
      if (!(iteration.energy < energy)) add("relaxation", {"the energy does not fall"});
      energy = iteration.energy;
    }
  }

  /// Runs a step; false where it throws a proper Error.
  template <class Step>
  bool attempt(const std::string& name, Step step) {
    try {
      step();
      return true;
    } catch (const Error& error) {
      last_error_ = error.what();
      last_code_ = error.code();
      add(name, test::examine(error));
      if (error.code() == ErrorCode::interrupted) add(name, {"does not end"});
    } catch (const std::exception& error) {
      add(name, {fmt::format("an exception that is no Error: {}", error.what())});
    }
    return false;
  }

  void add(const std::string& step, const Findings& findings) {
    for (const std::string& finding : findings) findings_.push_back(step + ": " + finding);
  }

  /// The same without impossible Euler characteristics of cells where these may come out.
  void add_sound(const std::string& step, Findings findings) {
    if (are_close_) std::erase_if(findings, [](const std::string& line) { return line.starts_with("(6)"); });
    add(step, findings);
  }

  Random random_;
  Counts& counts_;
  std::string name_, obj_, last_error_;
  ErrorCode last_code_{};
  std::vector<SurfacePoint> points_;
  bool are_close_ = false;       // labels and crossings are not compared: see kClose
  bool are_welded_ = false;      // cutting may fail: see kWelded
  bool has_thin_faces_ = false;  // the same: docs/developer/exact.md, "Close generators"
  Findings findings_;
};

/// Returns the number of seeds with findings, and prints each with its mesh. `verbose`: prints each seed before its run,
/// to identify one that crashes.
int run_seeds(unsigned first, unsigned count, bool verbose) {
  Counts counts;
  int failed = 0;
  for (unsigned seed = first; seed < first + count; ++seed) {
    if (verbose) std::cerr << "seed " << seed << '\n';
    FuzzCase fuzz(seed, counts);
    fuzz.run();
    if (fuzz.findings().empty()) continue;
    ++failed;
    UNSCOPED_INFO("seed " << seed << ": " << fuzz.findings().front() << "\n" << fuzz.describe());
    CHECK(fuzz.findings().empty());
  }
  std::cout << fmt::format(
      "{} meshes and {} refused; {} diagrams, {} times coincident generators; {} remeshes with {} one-to-one maps, {} "
      "refused; {} relaxed\n"
      "with close generators {} meshes, whose crossings were not compared; {} where cutting might fail; it failed {} "
      "times\n",
      counts.meshes, counts.refused, counts.diagrams, counts.coincident, counts.remeshes, counts.one_to_one,
      counts.without_remesh, counts.relaxed, counts.close, counts.welded, counts.uncut);
  return failed;
}

TEST_CASE("random soups with random generators end in sound results, or in an error that says why") {
  REQUIRE(run_seeds(kFirstSeed, kSeeds, false) == 0);
}

// By hand: make soups, with SOUPS_FIRST, SOUPS_COUNT and SOUPS_ALL=1.
TEST_CASE("more random soups", "[.by-hand]") {
  REQUIRE(run_seeds(test::number_from_environment("GVD_FUZZ_FIRST", 1000),
                    test::number_from_environment("GVD_FUZZ_COUNT", 10000), true) == 0);
}

}  // namespace gvd::test_pipeline
