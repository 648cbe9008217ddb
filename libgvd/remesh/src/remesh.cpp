// A remesh: rounds of a diagram and its dual, with new generators where the dual has defects.
//
// A round is a value: the triangles of the dual, the mesh that they make, and the defects in the way. Creases come
// first, then the topology, flipped triangles, and at last, on the placed mesh, triangles that intersect. Each defect
// asks for generators near it. The rounds end because each adds a generator and their number is limited; if it takes
// too many or too long, the component becomes its own triangles instead, decimated (DecimatedComponents). Then searches
// remove generators that were added in vain, or others for an exact number, and slivers are repaired. The certificate
// is measured on the result alone. docs/developer/remesh.md tells why the result is right.

#include "gvd/remesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "crease_defects.hpp"
#include "gvd/diagram_editor.hpp"
#include "gvd/error.hpp"
#include "gvd/sampling.hpp"
#include "gvd/text.hpp"
#include "mesh/component_topology.hpp"
#include "remesh_round.hpp"
#include "repair/added_generators.hpp"
#include "repair/decimated_components.hpp"
#include "repair/fewer_generators.hpp"
#include "repair/propose_generators.hpp"
#include "repair/repair_slivers.hpp"

namespace gvd {
namespace {

/// The largest number of generators that are added on creases. Following creases usually takes some percent more
/// generators, and curves that are close together up to twice as many. Beyond that, gaps stay.
std::int64_t max_on_creases(std::size_t generators) { return static_cast<std::int64_t>(generators) + 100; }

/// The fraction of the given generators that may be added without a search for fewer.
constexpr double kWorthSearching = 0.1;

/// The default of max_added may be raised by this factor if that is likely to be enough.
constexpr std::int64_t kRaisedLimit = 3;

/// The limit on the work of a search, as a fraction of the work of all other diagrams.
constexpr double kSearchShare = 1.0 / 3, kExchangeShare = 2;

/// The rounding of the length of creases that edges do not follow, relative to the length of all creases.
constexpr double kGapTolerance = 1e-9;

/// A placement of all vertices costs several times as much as the other steps of a round. After so many placements, a
/// component whose triangles still intersect is decimated, if it may be, instead of getting more generators.
constexpr std::int32_t kMaxPlacements = 20;
/// A surface of more components than this is an assembly, whose components often intersect each other wherever
/// generators are added. A hollow body has two components, which are repaired like one.
constexpr std::int32_t kMostOfBody = 8;
constexpr std::int32_t kMaxAssemblyPlacements = 2;

/// The number of windows that a repair may propagate before components with defects are decimated is the sum of three:
/// kRepairDiagrams times the windows of the first diagram; kRepairEventsPerFace for each face, because a first diagram
/// of few generators says little about later ones; and kRepairEvents, which take a fraction of a second on any mesh.
constexpr std::int64_t kRepairDiagrams = 60, kRepairEventsPerFace = 300, kRepairEvents = 200'000;

/// Ordinary faces have 10 to 30 windows, needles have hundreds, and a diagram of needles takes as long as twenty
/// ordinary ones. If the first diagram has more than kNeedleEventsPerFace windows for each face, only kNeedleRounds
/// rounds of repair follow, and none if most cells have a defect: then it would take several times the generators.
constexpr std::int64_t kNeedleEventsPerFace = 100;
constexpr std::int32_t kNeedleRounds = 1;

/// One component of an assembly may get as many added generators as it was given, and kLeastMeshes times the fewest
/// vertices of its topology. After that it becomes its own triangles, with fewer vertices, so that a small part does
/// not get more vertices than it is worth.
constexpr std::int64_t kLeastMeshes = 2;
/// The number of rounds in which such a component may have defects.
constexpr std::int32_t kMostComponentRounds = 8;

/// A repair is given up after so many rounds without fewer defects of one kind (in topology, flipped, intersecting)
/// than ever before. Successful repairs take at most 50 rounds, and nine of ten take at most 12.
constexpr std::int32_t kStagnantRounds = 20;

/// From this round on, a repair is given up if there are half as many defects again as at first, and one for every two
/// generators: the surface is then finer than their spacing nearly everywhere. Earlier rounds don't count, because few
/// generators have few defects at first.
constexpr std::int32_t kGrowthRound = 3;
/// The rule of kGrowthRound applies once components have so many generators on average, because the first few
/// generators always have defects: the first four of a sphere do.
constexpr std::size_t kGrowthGenerators = 8;

void check_options(const RemeshOptions& options, std::size_t generators) {
  if (options.max_added && *options.max_added < 0) {
    throw Error(ErrorCode::invalid_option, "max_added must not be negative", *options.max_added);
  }
  check_placement(options.placement, generators);
}

std::string others(std::size_t count) {
  return count == 0 ? "" : ", and " + counted(std::int64_t(count), "more defect", "more defects");
}

/// The points of some generators, in the order of their ids.
std::vector<SurfacePoint> list_points(const std::vector<SurfacePoint>& generators, std::vector<GeneratorId> ids) {
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  std::vector<SurfacePoint> points;
  for (const GeneratorId g : ids) points.push_back(generators[g.index()]);
  return points;
}

/// The rounds of a remesh, then the searches, the repair of slivers, and the certificate. They are in one class because
/// each of these steps replaces the one result, under the same conditions (`take_if`).
class Remesher {
 public:
  /// Mesh and options must outlive this.
  Remesher(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const RemeshOptions& options)
      : mesh_(mesh),
        options_(options),
        fixed_(list_points(generators, options.placement.fixed)),
        max_added_(options.max_added.value_or(default_max_added(compute_mesh_summary(mesh), generators.size()))),
        creases_(mesh, options.creases, options.refine && !options.vertex_count ? max_on_creases(generators.size()) : 0,
                 even_spacing(compute_area(mesh), std::ssize(generators))) {
    result_.generators = generators;
    stays_ = fixed_;
    components_ = topologies_.size();
    given_to_.resize(components_);
    added_to_.resize(components_);
    rounds_of_.resize(components_);
    for (const SurfacePoint& point : generators) ++given_to_[component_of(point)];
  }

  /// `first` is the diagram of the given generators. Returns Error{no_valid_result} if no proper mesh is found.
  OrError<RemeshResult> run(Diagram&& first) {
    result_.diagram = std::move(first);
    first_events_ = result_.diagram.report.propagation_events;
    earlier_events_ = events_ = first_events_ * std::max(std::int64_t{1}, options_.earlier_diagrams);
    while (!ends_with_round()) {
      enter(RemeshStage::diagram);
      update_diagram();
      events_ += result_.diagram.report.propagation_events;
    }
    editor_.reset();
    if (!refusal_ && !decimated_) improve();
    if (!refusal_) measure();
    if (refusal_) return *std::move(refusal_);
    return std::move(result_);
  }

 private:
  static constexpr std::size_t kNoDefects = std::numeric_limits<std::size_t>::max();

  void enter(RemeshStage stage) const {
    if (options_.on_stage) options_.on_stage(stage);
  }

  void take(RemeshRound&& round) {
    result_.mesh = std::move(round.mesh);
    result_.face_points = std::move(round.face_points);
    result_.flips = std::move(round.flips);
  }

  /// One round of the diagram. Takes its mesh and returns true if nothing is left to do; else adds generators. It also
  /// returns true, with a refusal, if no generators can be added.
  bool ends_with_round() {
    ++result_.rounds;
    enter(RemeshStage::dual);
    RemeshRound round = maker_.build(result_.diagram, result_.rounds);
    if (!round.obstacle.empty()) {
      refusal_.emplace(ErrorCode::no_valid_result, round.obstacle);
      return true;
    }
    const bool follows_creases = follow_creases();
    if (!follows_creases && round.defects.empty()) {
      enter(RemeshStage::placement);
      maker_.place(result_.diagram, round);
      ++placements_;
    }
    if (result_.rounds == 1) result_.given_defects = round.defects;
    if (!round.defects.empty()) note_defects(round.defects);
    if (follows_creases) return false;
    // Once duals are given up, a dual that meets decimated faces is decimated as well, and these faces need no
    // refinement.
    const bool duals_go = given_up_ && !round.defects.empty();
    if (!round.decimated_wrong.empty() && !duals_go) refine_decimated(round);
    if (!round.defects.empty()) {
      refine(round.defects);
    } else if (!round.decimated_wrong.empty()) {
      replace_decimated();
    } else if (missing() > 0) {
      fill();
    } else {
      take(std::move(round));
      return true;
    }
    return refusal_.has_value();
  }

  /// Notes the number of defects, and the last round that had fewer defects of a kind than all rounds before.
  void note_defects(const std::vector<DualDefect>& defects) {
    history_.emplace_back(result_.added, defects.size());
    const DualProperty property = defects.front().property;
    std::size_t& least = least_defects_[property < DualProperty::not_flipped    ? 0
                                        : property == DualProperty::not_flipped ? 1
                                                                                : 2];
    if (defects.size() >= least) return;
    least = defects.size();
    progress_round_ = result_.rounds;
  }

  /// Updates the diagram after generators were added. An exact diagram is computed anew once; from then on, only the
  /// cells that change.
  void update_diagram() {
    if (options_.diagram.method != Method::exact) {
      result_.diagram = compute_diagram(mesh_, result_.generators, options_.diagram);
      return;
    }
    if (editor_) {
      const auto first = result_.generators.begin() + std::ssize(editor_->generators());
      editor_->add(std::vector<SurfacePoint>(first, result_.generators.end()));
    } else {
      editor_.emplace(mesh_, result_.generators, options_.diagram);
    }
    result_.diagram = editor_->diagram();
  }

  /// Adds generators on creases. They come before repairs, because they often make repairs unnecessary. False if none
  /// is added.
  bool follow_creases() {
    const std::int64_t room = decimated_ ? 0 : max_added_ - result_.added;
    const std::vector<SurfacePoint> points = creases_.propose(result_.diagram, room);
    result_.crease_gap_length = creases_.gap_length();
    result_.creases_lack_added = !decimated_ && creases_.is_held_back();
    stays_.insert(stays_.end(), points.begin(), points.end());
    append(points);
    return !points.empty();
  }

  void append(const std::vector<SurfacePoint>& points) {
    result_.generators.insert(result_.generators.end(), points.begin(), points.end());
    result_.added += std::ssize(points);
  }

  /// How many more vertices were asked for than there are generators; below 0 if there are too many generators.
  std::int64_t missing() const {
    return options_.vertex_count ? *options_.vertex_count - std::ssize(result_.generators) : 0;
  }

  /// Adds the generators that are missing for the number of vertices asked for.
  void fill() {
    const auto points = propose_farthest(mesh_, result_.diagram, missing());
    if (points.empty()) return refuse_count("there is no room for more generators");
    append(points);
  }

  void refine(const std::vector<DualDefect>& defects) {
    if (!options_.refine)
      return refuse(defects, "give more generators there, or leave \1?refine=false|exact_count\2 out");
    if (result_.added >= max_added_) raise_limit();
    const std::int64_t may_add = max_added_ - result_.added;
    const bool is_over = may_add <= 0 || result_.rounds >= kMaxRemeshRounds;
    if (!given_up_) given_up_ = is_over ? std::optional(DecimationCause::work) : find_hopeless(defects);
    if (may_decimate() && given_up_) return decimate(defects, *given_up_);
    if (may_decimate() && is_assembly()) {
      count_rounds(defects);
      const std::vector<DualDefect> spent = find_spent(defects);
      if (!spent.empty()) return decimate(spent, DecimationCause::generators);
    }
    if (is_over) {
      const MeshSummary summary = compute_mesh_summary(mesh_);
      return refuse(defects, fmt::format("{} added in {}{}", counted(result_.added, "generator was", "generators were"),
                                         counted(result_.rounds, "round", "rounds"),
                                         advise_at_limit(summary, result_.generators.size(), history_, may_add <= 0,
                                                         default_max_added(summary, given_count()))));
    }
    const auto [points, narrow] =
        propose_generators(mesh_, result_.diagram, defects, may_add, options_.diagram.progress);
    if (narrow && may_decimate()) return decimate_around(narrow->tip, defects);
    if (points.empty() && may_decimate()) return decimate(defects, DecimationCause::no_room);
    if (narrow) return refuse(defects, describe(mesh_, *narrow));
    if (points.empty()) {
      return refuse(defects,
                    "every point for a new generator is too close to another one; move or remove generators there");
    }
    const auto nearby = propose_nearby(mesh_, result_.diagram, points, may_add - points.size(), options_.diagram);
    for (const auto* const more : {&points, &nearby.points}) {
      append(*more);
      for (const SurfacePoint& point : *more) ++added_to_[component_of(point)];
    }
    events_ += nearby.events;
  }

  bool is_assembly() const { return components_ > kMostOfBody; }

  /// Why more generators won't lead to a right dual, or not in time; nothing if they may.
  std::optional<DecimationCause> find_hopeless(const std::vector<DualDefect>& defects) const {
    // Triangles that intersect are looked for only if nothing else is wrong, so their number says nothing about growth.
    const bool is_topology = defects.front().property < DualProperty::not_flipped;
    const std::size_t generators = result_.generators.size();
    const bool has_enough = is_topology && generators >= kGrowthGenerators * components_;
    const bool are_needles = first_events_ > kNeedleEventsPerFace * mesh_.face_count() + kRepairEvents;
    if (are_needles && (result_.rounds > kNeedleRounds || (has_enough && 2 * count_cells(defects) > generators)))
      return DecimationCause::work;
    const std::int64_t most_events =
        kRepairDiagrams * first_events_ + kRepairEventsPerFace * mesh_.face_count() + kRepairEvents;
    if (result_.rounds - progress_round_ >= kStagnantRounds) return DecimationCause::work;
    const std::int32_t most_placements = is_assembly() ? kMaxAssemblyPlacements : kMaxPlacements;
    if (placements_ >= most_placements || events_ - earlier_events_ > most_events) return DecimationCause::work;
    const bool has_grown = result_.rounds >= kGrowthRound && 2 * defects.size() > 3 * history_.front().second;
    return has_enough && has_grown && 2 * defects.size() > generators ? std::optional(DecimationCause::growth)
                                                                      : std::nullopt;
  }

  /// The number of cells with a defect.
  static std::size_t count_cells(const std::vector<DualDefect>& defects) {
    std::set<GeneratorId> cells;
    for (const DualDefect& d : defects) cells.insert(d.cells.begin(), d.cells.end());
    return cells.size();
  }

  std::int32_t component_of(const DualDefect& defect) const {
    return defect.cells.empty() ? defect.component : component_of(result_.generators[defect.cells.front().index()]);
  }

  /// The defects of components that have used up the generators that one component may be given. If more components
  /// have no generator than generators were given, there are too few generators for a dual of all, and components
  /// without one count as well.
  std::vector<DualDefect> find_spent(std::vector<DualDefect> defects) const {
    const auto is_unreached = [](const DualDefect& d) { return d.cells.empty(); };
    const bool are_too_few = std::count_if(defects.begin(), defects.end(), is_unreached) > given_count();
    std::erase_if(defects, [&](const DualDefect& d) {
      if (is_unreached(d)) return !are_too_few;
      const std::int32_t c = component_of(d);
      return rounds_of_[c] <= kMostComponentRounds &&
             added_to_[c] <= given_to_[c] + kLeastMeshes * least_vertices(topologies_[c]);
    });
    return defects;
  }

  /// Counts this round for each component with defects.
  void count_rounds(const std::vector<DualDefect>& defects) {
    std::set<std::int32_t> components;
    for (const DualDefect& d : defects) components.insert(component_of(d));
    for (const std::int32_t c : components) ++rounds_of_[c];
  }

  /// Whether components may be decimated. A user who asks for an exact number of vertices, for the given generators
  /// alone or for a limit gets a refusal instead.
  bool may_decimate() const {
    return options_.may_decimate && options_.refine && !options_.vertex_count && !options_.max_added;
  }

  /// Gives up the dual of the components with these defects: their own triangles, decimated, take its place.
  void decimate(const std::vector<DualDefect>& defects, DecimationCause cause) {
    if (!decimated_) {
      decimated_.emplace(mesh_, even_spacing(compute_area(mesh_), given_count()));
      result_.decimated.reason = defects.front().message;
    }
    std::map<std::int32_t, std::int64_t> vertices_of;
    for (const DualDefect& d : defects) {
      const std::int32_t c = component_of(d);
      vertices_of[c] = std::max(given_to_[c], least_vertices(topologies_[c]));
    }
    for (const auto& [component, vertices] : vertices_of) result_.decimated.generators += given_to_[component];
    result_.decimated.causes[cause] += std::ssize(vertices_of);
    decimated_->add(vertices_of);
    replace_decimated();
  }

  /// The same for the one component of a vertex around which generators have no room.
  void decimate_around(VertexId vertex, std::vector<DualDefect> defects) {
    const std::int32_t chosen = component_[Mesh::face(mesh_.halfedge(vertex))];
    std::erase_if(defects, [&](const DualDefect& d) { return component_of(d) != chosen; });
    decimate(defects, DecimationCause::narrow_tip);
  }

  std::int32_t component_of(const SurfacePoint& point) const { return component_[point.face]; }

  void refine_decimated(const RemeshRound& round) {
    const auto on_surface = [&](VertexId v) { return vertex(mesh_, result_.generators[v.index()]); };
    for (const FaceId f : round.decimated_wrong) {
      const auto& [a, b, c] = round.mesh.vertices(f);
      decimated_->refine(round.mesh, f, {on_surface(a), on_surface(b), on_surface(c)});
    }
  }

  /// Replaces all generators of decimated components by the components' vertices, which come before the added
  /// generators.
  void replace_decimated() {
    decimated_->decimate(options_.diagram.progress);
    const auto is_decimated = [&](const SurfacePoint& point) { return decimated_->has(point); };
    std::vector<SurfacePoint> added(result_.generators.end() - result_.added, result_.generators.end());
    result_.generators.resize(given_count());
    for (auto* const points : {&result_.generators, &added, &fixed_, &stays_}) std::erase_if(*points, is_decimated);
    const std::vector<VertexId> vertices = decimated_->vertices();
    for (const VertexId v : vertices) result_.generators.push_back(vertex_point(mesh_, v));
    result_.generators.insert(result_.generators.end(), added.begin(), added.end());
    result_.added = std::ssize(added);
    result_.decimated.components = decimated_->count();
    result_.decimated.vertices = std::ssize(vertices);
    editor_.reset();
  }

  /// Raises the default limit, once, if the raised limit is likely to be enough.
  void raise_limit() {
    const MeshSummary summary = compute_mesh_summary(mesh_);
    const std::int64_t usual = default_max_added(summary, given_count());
    if (options_.max_added || max_added_ > usual) return;
    const auto need = estimate_added(summary, result_.generators.size(), history_);
    if (need && *need <= kRaisedLimit * usual) max_added_ = kRaisedLimit * usual;
  }

  std::string all_generators() const { return counted(std::ssize(result_.generators), "generator", "generators"); }

  void refuse(const std::vector<DualDefect>& defects, const std::string& advice) {
    const auto& cells = defects.front().cells;
    const bool intersects = defects.front().property == DualProperty::no_self_intersection;
    refusal_.emplace(
        ErrorCode::no_valid_result,
        fmt::format("the dual of {} is no valid mesh: {}{}; {}{}", all_generators(), defects.front().message,
                    others(defects.size() - 1), advice, intersects ? ", or give \1allow_intersections\2" : ""),
        cells.empty() ? -1 : cells.front().value());
  }

  /// Refuses the number of vertices that was asked for.
  void refuse_count(const std::string& why) {
    refusal_.emplace(
        ErrorCode::no_valid_result,
        fmt::format("no valid mesh of {} was found: {}", counted(*options_.vertex_count, "vertex", "vertices"), why));
  }

  std::int64_t given_count() const { return std::ssize(result_.generators) - result_.added; }

  /// Whether a search for fewer generators is worth its time. Generators that were added on creases stay.
  bool is_worth_searching() const {
    return double(result_.added - creases_.added()) > kWorthSearching * double(given_count());
  }

  /// `share` limits the work of the search, as a fraction of the work of the other diagrams.
  GeneratorSearch search(std::size_t kept, double share) {
    enter(RemeshStage::search);
    const auto least = std::size_t(options_.vertex_count.value_or(0));
    return {kept,
            stays_,
            least,
            std::int64_t(share * double(events_)),
            options_.diagram,
            {},
            [this](const std::vector<SurfacePoint>& generators) { return take_if_right(generators); }};
  }

  /// Improves a right dual of the whole surface.
  void improve() {
    if (is_worth_searching()) search_fewer();
    if (missing() < 0) exchange();
    repair_thin_triangles();
  }

  void search_fewer() {
    const std::int64_t given = given_count();
    result_.search_cut_short = !search_fewer_generators(mesh_, result_.diagram, search(given, kSearchShare));
    result_.added = std::ssize(result_.generators) - given;
  }

  /// Removes given generators to make room for those that were added.
  void exchange() {
    const std::vector<SurfacePoint> before = result_.generators;
    const std::int64_t given = given_count(), count = *options_.vertex_count;
    exchange_generators(mesh_, result_.diagram, search(options_.kept, kExchangeShare));
    if (missing() < 0) return refuse_count(fmt::format("the search ended at {}", result_.generators.size()));
    const std::vector<SurfacePoint> first(before.begin(), before.begin() + given);
    const std::int64_t left = std::ssize(find_in_order(result_.generators, first));
    result_.left_out = given - left;
    result_.added = count - left;
  }

  void repair_thin_triangles() {
    if (!options_.refine || options_.vertex_count) return;
    const std::int64_t given = given_count();
    const auto has_fewer = [&](const Mesh& m) { return find_slivers(m).size() < find_slivers(result_.mesh).size(); };
    repair_slivers(mesh_, result_.diagram, result_.mesh, max_added_ - result_.added,
                   [&](const std::vector<SurfacePoint>& generators) { return take_if(generators, has_fewer); });
    result_.added = std::ssize(result_.generators) - given;
  }

  bool take_if_right(const std::vector<SurfacePoint>& generators) {
    return take_if(generators, [](const Mesh&) { return true; });
  }

  /// Replaces the result by that of these generators if their dual has no defect, edges follow as much of the creases
  /// as before, and the mesh is accepted.
  template <class IsAccepted>
  bool take_if(const std::vector<SurfacePoint>& generators, IsAccepted is_accepted) {
    Diagram diagram = compute_diagram(mesh_, generators, options_.diagram);
    creases_.propose(diagram, 0);
    if (creases_.gap_length() > result_.crease_gap_length + kGapTolerance * creases_.length()) return false;
    RemeshRound round = maker_.build(diagram, result_.rounds);
    if (!round.obstacle.empty()) return false;
    if (round.defects.empty()) maker_.place(diagram, round);
    if (!round.defects.empty() || !is_accepted(round.mesh)) return false;
    result_.crease_gap_length = creases_.gap_length();
    result_.generators = generators;
    result_.diagram = std::move(diagram);
    take(std::move(round));
    return true;
  }

  /// Certifies the result and measures it.
  void measure() {
    enter(RemeshStage::distance);
    result_.slivers = find_slivers(result_.mesh);
    const int threads = options_.diagram.threads;
    const auto half = [&](double begin) {
      return Progress([&, begin](std::string_view step, double done) {
        return !options_.diagram.progress || options_.diagram.progress(step, begin + 0.5 * done);
      });
    };
    result_.certificate = certify_remesh(mesh_, result_.diagram, result_.mesh, result_.face_points, threads,
                                         decimated_ ? std::ssize(decimated_->faces()) : 0);
    result_.certificate.intersections_allowed = options_.allow_intersections;
    if (!result_.certificate.ok()) {
      refusal_.emplace(ErrorCode::no_valid_result,
                       fmt::format("the remesh of {} can't be certified: {}; give other generators", all_generators(),
                                   result_.certificate.first_failure()));
      return;
    }
    result_.max_added = max_added_;
    result_.added_on_creases = std::ssize(stays_) - std::ssize(fixed_);
    result_.crease_length = creases_.length();
    result_.input_quality = compute_triangle_quality(mesh_);
    result_.output_quality = compute_triangle_quality(result_.mesh);
    result_.input_to_output = measure_surface_distance(mesh_, result_.mesh, threads, half(0));
    result_.output_to_input = measure_surface_distance(result_.mesh, mesh_, threads, half(0.5));
  }

  const Mesh& mesh_;
  const RemeshOptions& options_;
  std::vector<SurfacePoint> fixed_;  // as points, because an exchange changes ids
  std::vector<SurfacePoint> stays_;  // in a search: the fixed ones, and those added on creases
  std::int64_t max_added_;
  CreaseFollower creases_;
  RemeshResult result_;
  RepairHistory history_;
  const IdVector<FaceId, std::int32_t> component_ = compute_face_components(mesh_);
  const std::vector<ComponentTopology> topologies_ = compute_topologies(mesh_, component_);
  std::size_t components_ = 0;                     // of the surface
  std::vector<std::int32_t> rounds_of_;            // of each component: those that found defects
  std::vector<std::int64_t> given_to_, added_to_;  // generators of each component: given, and added in repairs
  std::optional<DecimationCause> given_up_;        // why each component that still has defects is decimated
  std::array<std::size_t, 3> least_defects_{kNoDefects, kNoDefects, kNoDefects};  // in a round, by their kind
  std::int32_t progress_round_ = 0;                     // the last one that had fewer defects of a kind than all before
  std::int32_t placements_ = 0;                         // of all vertices, in rounds
  std::int64_t first_events_ = 0, earlier_events_ = 0;  // of the first diagram, and of all until then
  std::int64_t events_ = 0;                             // windows propagated in all diagrams but those of searches
  std::optional<DecimatedComponents> decimated_;        // once a component has no right dual
  RoundMaker maker_{mesh_, options_, fixed_, decimated_};
  std::optional<DiagramEditor> editor_;  // of the rounds, from the second on
  std::optional<Error> refusal_;         // why there is no mesh, once that is known
};

}  // namespace

std::int64_t default_max_added(const MeshSummary& mesh, std::size_t generators) {
  const std::int64_t handles = twice_genus(mesh.components, mesh.boundary_loops, mesh.euler_characteristic) / 2;
  const std::int64_t topology = std::int64_t{mesh.components} + mesh.boundary_loops + handles;
  return 10 * (static_cast<std::int64_t>(generators) + topology) + 100;
}

RemeshResult remesh(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const RemeshOptions& options) {
  return value_or_throw(try_to_remesh(mesh, generators, options));
}

RemeshResult remesh(const Mesh& mesh, Diagram diagram, const RemeshOptions& options) {
  return value_or_throw(try_to_remesh(mesh, std::move(diagram), options));
}

OrError<RemeshResult> try_to_remesh(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                                    const RemeshOptions& options) {
  check_options(options, generators.size());
  if (options.on_stage) options.on_stage(RemeshStage::diagram);
  return try_to_remesh(mesh, compute_diagram(mesh, generators, options.diagram), options);
}

OrError<RemeshResult> try_to_remesh(const Mesh& mesh, Diagram diagram, const RemeshOptions& options) {
  check_options(options, diagram.generators.size());
  const bool fits = std::ssize(diagram.vertex_label) == mesh.vertex_count() &&
                    std::ssize(diagram.face_label) == mesh.face_count() && !diagram.generators.empty();
  if (!fits) throw Error(ErrorCode::precondition, "the diagram is not one of the mesh; compute it of this mesh");
  return Remesher(mesh, diagram.generators, options).run(std::move(diagram));
}

}  // namespace gvd
