#include "gvd/remesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <utility>

#include "creases/follow_creases.hpp"
#include "dual_mesh_maker.hpp"
#include "gvd/error.hpp"
#include "gvd/mesh.hpp"
#include "gvd/sampling.hpp"
#include "gvd/text.hpp"
#include "repair/fewer_generators.hpp"
#include "repair/propose_generators.hpp"
#include "repair/propose_nearby.hpp"

namespace gvd {
namespace {

/// Creases that are followed take some percent more generators, and close curves up to twice as many. What is more
/// than that stays as it is.
std::int64_t max_on_creases(std::size_t generators) { return static_cast<std::int64_t>(generators) + 100; }

/// Where more than this fraction of the given generators was added, fewer are looked for.
constexpr double kWorthSearching = 0.1;

void check_options(const RemeshOptions& options, std::size_t generators) {
  if (options.max_added && *options.max_added < 0) {
    throw Error(ErrorCode::invalid_option, "max_added must not be negative", *options.max_added);
  }
  check_placement(options.placement, generators);
}

std::string describe(const Mesh& mesh, const NarrowTip& narrow) {
  const Vec3& at = mesh.position(narrow.tip);
  const std::string advice = narrow.least_distance < mesh.bbox_diagonal()
                                 ? fmt::format("remove the generators nearer than {:.3g} to it", narrow.least_distance)
                                 : "cut the surface off there";
  return fmt::format(
      "the total angle of vertex {} at ({:.6g}, {:.6g}, {:.6g}) is {:.3g} degrees, and three generators "
      "round it would be too close to each other; {}",
      narrow.tip.value(), at.x(), at.y(), at.z(), narrow.angle * 180 / std::numbers::pi, advice);
}

std::string others(std::size_t count) {
  return count == 0 ? "" : ", and " + counted(static_cast<std::int64_t>(count), "more defect", "more defects");
}

/// The rounds of a remesh: diagram, dual, new generators where it has defects; then the search and the certificate.
class Remesher {
 public:
  Remesher(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const RemeshOptions& options)
      : mesh_(mesh),
        options_(options),
        max_added_(options.max_added.value_or(default_max_added(compute_mesh_summary(mesh), generators.size()))),
        creases_(mesh, options.creases, options.refine ? max_on_creases(generators.size()) : 0,
                 even_spacing(compute_area(mesh), std::ssize(generators))) {
    result_.generators = generators;
  }

  RemeshResult run() {
    enter(RemeshStage::diagram);
    return run(compute_diagram(mesh_, result_.generators, options_.diagram));
  }

  /// `first`: of the given generators.
  RemeshResult run(Diagram&& first) {
    result_.diagram = std::move(first);
    while (true) {
      ++result_.rounds;
      enter(RemeshStage::dual);
      const DualMesh dual = build_dual(mesh_, result_.diagram);
      std::vector<DualDefect> defects = maker_.build(dual);
      if (result_.rounds == 1) result_.given_defects = defects;
      if (!follow_creases()) {
        if (defects.empty()) {
          enter(RemeshStage::placement);
          defects = maker_.place(dual);
          if (result_.rounds == 1) result_.given_defects = defects;
        }
        if (defects.empty()) break;
        refine(defects);
      }
      enter(RemeshStage::diagram);
      result_.diagram = compute_diagram(mesh_, result_.generators, options_.diagram);
    }
    if (is_worth_searching()) search_fewer();
    measure();
    return std::move(result_);
  }

 private:
  void enter(RemeshStage stage) const {
    if (options_.on_stage) options_.on_stage(stage);
  }

  /// Adds generators on creases. They come before repairs, which they often make needless.
  bool follow_creases() {
    const std::vector<SurfacePoint> points = creases_.propose(result_.diagram, max_added_ - result_.added);
    result_.crease_gap_length = creases_.gap_length();
    append(points);
    return !points.empty();
  }

  void append(const std::vector<SurfacePoint>& points) {
    result_.generators.insert(result_.generators.end(), points.begin(), points.end());
    result_.added += static_cast<std::int64_t>(points.size());
  }

  void refine(const std::vector<DualDefect>& defects) {
    if (!options_.refine) refuse(defects, "give more generators there, or set refine");
    const std::int64_t may_add = max_added_ - result_.added;
    if (may_add <= 0 || result_.rounds >= kMaxRemeshRounds) {
      refuse(defects,
             fmt::format("{} added in {}: give more or other ones{}",
                         counted(result_.added, "generator was", "generators were"),
                         counted(result_.rounds, "round", "rounds"), may_add <= 0 ? ", or raise max_added" : ""));
    }
    const auto [points, narrow] =
        propose_generators(mesh_, result_.diagram, defects, static_cast<std::size_t>(may_add));
    if (narrow) refuse(defects, describe(mesh_, *narrow));
    if (points.empty()) {
      refuse(defects, "every point for a new generator is too close to another one; move or remove generators there");
    }
    const auto nearby = propose_nearby(mesh_, result_.diagram, points,
                                       static_cast<std::size_t>(may_add) - points.size(), options_.diagram);
    append(points);
    append(nearby);
  }

  std::string all_generators() const { return counted(std::ssize(result_.generators), "generator", "generators"); }

  [[noreturn]] void refuse(const std::vector<DualDefect>& defects, const std::string& advice) const {
    const auto& cells = defects.front().cells;
    const bool intersects = defects.front().property == DualProperty::no_self_intersection;
    throw Error(ErrorCode::no_valid_result,
                fmt::format("the dual of {} is no valid mesh: {}{}; {}{}", all_generators(), defects.front().message,
                            others(defects.size() - 1), advice, intersects ? ", or set allow_intersections" : ""),
                cells.empty() ? -1 : cells.front().value());
  }

  std::size_t given_count() const { return result_.generators.size() - static_cast<std::size_t>(result_.added); }

  /// Not where edges shall follow creases: fewer generators could leave these.
  bool is_worth_searching() const {
    return options_.creases.empty() &&
           static_cast<double>(result_.added) > kWorthSearching * static_cast<double>(given_count());
  }

  void search_fewer() {
    enter(RemeshStage::search);
    FewerGenerators fewer(mesh_, result_.diagram, given_count(), options_.diagram,
                          [this](const std::vector<SurfacePoint>& generators) { return take_if_right(generators); });
    fewer.search();
  }

  /// Makes the result that of these generators, with the same given ones, if their dual has no defect.
  bool take_if_right(const std::vector<SurfacePoint>& generators) {
    RemeshResult before = result_;
    result_.added -= std::ssize(result_.generators) - std::ssize(generators);
    result_.generators = generators;
    try {
      result_.diagram = compute_diagram(mesh_, generators, options_.diagram);
      const DualMesh dual = build_dual(mesh_, result_.diagram);
      if (maker_.build(dual).empty() && maker_.place(dual).empty()) return true;
    } catch (const Error& error) {
      if (error.code() != ErrorCode::no_valid_result) throw;
    }
    result_ = std::move(before);
    return false;
  }

  void measure() {
    enter(RemeshStage::distance);
    result_.certificate =
        certify_remesh(mesh_, result_.mesh, result_.generators, result_.face_points, options_.diagram.threads);
    result_.certificate.intersections_allowed = options_.allow_intersections;
    if (!result_.certificate.ok()) {
      throw Error(ErrorCode::no_valid_result,
                  fmt::format("the remesh of {} can't be certified: {}; give other generators", all_generators(),
                              result_.certificate.first_failure()));
    }
    result_.added_on_creases = creases_.added();
    result_.crease_length = creases_.length();
    result_.input_quality = compute_triangle_quality(mesh_);
    result_.output_quality = compute_triangle_quality(result_.mesh);
    result_.input_to_output = measure_surface_distance(mesh_, result_.mesh, options_.diagram.threads);
    result_.output_to_input = measure_surface_distance(result_.mesh, mesh_, options_.diagram.threads);
  }

  const Mesh& mesh_;
  const RemeshOptions& options_;
  std::int64_t max_added_;
  CreaseFollower creases_;
  RemeshResult result_;
  DualMeshMaker maker_{mesh_, options_, result_};
};

}  // namespace

std::int64_t default_max_added(const MeshSummary& mesh, std::size_t generators) {
  const std::int64_t handles = (2 * mesh.components - mesh.boundary_loops - mesh.euler_characteristic) / 2;
  const std::int64_t topology = std::int64_t{mesh.components} + mesh.boundary_loops + handles;
  return 10 * (static_cast<std::int64_t>(generators) + topology) + 100;
}

RemeshResult remesh(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const RemeshOptions& options) {
  check_options(options, generators.size());
  return Remesher(mesh, generators, options).run();
}

RemeshResult remesh(const Mesh& mesh, Diagram diagram, const RemeshOptions& options) {
  check_options(options, diagram.generators.size());
  const bool fits = std::ssize(diagram.vertex_label) == mesh.vertex_count() &&
                    std::ssize(diagram.face_label) == mesh.face_count() && !diagram.generators.empty();
  if (!fits) throw Error(ErrorCode::precondition, "the diagram is not one of the mesh; compute it of this mesh");
  return Remesher(mesh, diagram.generators, options).run(std::move(diagram));
}

}  // namespace gvd
