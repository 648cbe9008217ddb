// The operation `segment`: regions to keep to, a diagram inside them, and its cells as labels of faces or as pieces.
//
// Whole faces get the label of the generator whose cell has them, so that borders run along edges; or the faces are
// split along the bisectors, and each new face knows its parent (gvd/segment.hpp). Each level but the last labels whole
// faces, and its labels are the regions of the next one. Given regions are the first level's; a mask takes faces out of
// them, or out of the whole surface. All results have the input's faces or pieces of them, and its vertices.

#include "gvd/segment_operation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "gvd/barriers.hpp"
#include "gvd/diagram_options.hpp"
#include "gvd/diagram_parts.hpp"
#include "gvd/disc_cells.hpp"
#include "gvd/error.hpp"
#include "gvd/io/format.hpp"
#include "gvd/segment_options.hpp"
#include "gvd/text.hpp"
#include "weighted_diagram.hpp"

namespace gvd {
namespace {

/// A note names this many generators or regions.
constexpr std::size_t kNamed = 8;

/// Borders of a greater multiple of the bisectors' length get a note. Of 509 runs on 77 meshes with 50 or more faces
/// for each generator, 491 stay below it; with fewer the mesh is too coarse.
constexpr double kUsualBorderRatio = 1.14;

/// The first ids, and "..." where there are more.
std::string name_some(const std::vector<GeneratorId>& ids) {
  std::vector<std::int32_t> named;
  for (std::size_t i = 0; i < std::min(kNamed, ids.size()); ++i) named.push_back(ids[i].value());
  return fmt::format("{}{}", fmt::join(named, ", "), named.size() < ids.size() ? ", ..." : "");
}

// ---- the regions

// A level needs no figures of its own: a segmentation with its number of generators has the same ones.
void label_levels(const Mesh& mesh, const SegmentCall& call, Observer& observer, PartedMesh& parted) {
  LevelOptions level;
  level.generators.sampling = make_sampling_options(call.generators, call.diagram, observer);
  level.diagram = call.diagram;
  level.diagram.progress = progress_of(observer);
  level.labels = {call.segmentation.labels, progress_of(observer)};
  for (std::size_t i = 0; i + 1 < call.levels.size(); ++i) {
    level.generators.sampling.count = call.levels[i];
    const std::string name = level_name(i + 1);
    const auto found = as_step(observer, name, [&] { return label_level(mesh, parted.regions, level); });
    parted.regions = to_regions(found);
    parted.numbers.push_back({name, parted.regions});
  }
}

PartedMesh part(const CheckedMesh& input, const SegmentCall& call, Observer& observer) {
  PartedMesh parted = find_parted(input, call.regions, observer);
  parted.levels = call.levels.size();
  label_levels(input.mesh, call, observer, parted);
  separate(input.mesh, parted, observer);
  return parted;
}

// ---- the generators and their diagram

Diagram make_cells_discs(const SegmentCall& call, Observer& observer, const Diagram& diagram, SegmentOutcome& outcome) {
  DiscOptions options;
  options.diagram = call.diagram;
  options.diagram.progress = progress_of(observer);
  DiscCells made = as_step(observer, "discs", [&] { return make_discs(outcome.surface(), diagram, options); });
  outcome.discs = {made.added, made.rounds, made.search_cut_short};
  if (made.added > 0) {
    outcome.snap_distance.resize(made.diagram.generators.size());
    observer.note(fmt::format("{} added, so that every cell is a disc{}",
                              counted(made.added, "generator was", "generators were"),
                              made.search_cut_short ? "; fewer may do" : ""));
    tell_diagram(observer, made.diagram);
  }
  return std::move(made.diagram);
}

// ---- the faces

void note_non_discs(Observer& observer, const Mesh& mesh, const IdVector<FaceId, GeneratorId>& label, const char* why) {
  const std::vector<GeneratorId> regions = find_non_disc_regions(mesh, label);
  if (regions.empty()) return;
  observer.note(fmt::format("{}: {}; {}",
                            counted(std::ssize(regions), "region is no disc although its cell is",
                                    "regions are no discs although their cells are"),
                            name_some(regions), why));
}

/// Notes the faces that no generator reaches, and why. Returns their number.
std::int64_t note_unreached(Observer& observer, const SegmentOutcome& outcome) {
  const IdVector<FaceId, GeneratorId>& label = outcome.face_labels();
  std::vector<FaceId> reached, unreached;  // faces of the input
  for (const FaceId f : label.ids()) {
    const FaceId whole = outcome.cut ? outcome.cut->parent[f] : f;
    if (!outcome.parted.is_left_out(whole)) (label[f].valid() ? reached : unreached).push_back(whole);
  }
  if (unreached.empty()) return 0;
  const Barriers barriers(*outcome.input);
  const Barriers::Origin origin = barriers.from(reached);
  BarrierCounts counts;
  for (const FaceId f : unreached) counts.add(barriers.between(origin, f));
  observer.note(fmt::format("{} reached by no generator and {} label -1: {}",
                            counted(std::ssize(unreached), "face is", "faces are"),
                            unreached.size() == 1 ? "gets" : "get", counts.describe("in another region")));
  return std::ssize(unreached);
}

/// Notes generators without a face. Returns the length of the borders by that of the bisectors; 0 without bisectors.
double tell_segmentation(Observer& observer, const SegmentOutcome& outcome) {
  const std::vector<GeneratorId>& without = outcome.whole->without_face;
  if (!without.empty()) {
    observer.note(fmt::format("{} inside faces of other regions: {}",
                              counted(std::ssize(without), "generator owns no face, its cell lies",
                                      "generators own no face, their cells lie"),
                              name_some(without)));
  }
  const double bisectors = outcome.diagram->length;
  if (!(bisectors > 0)) return 0;
  const double ratio = outcome.border_length / bisectors;
  observer.detail(
      fmt::format("borders of length {:.6g}, {:.3f} times that of the bisectors", outcome.border_length, ratio));
  return ratio;
}

/// Notes smooth borders that are longer than usual.
void note_long_borders(Observer& observer, double ratio) {
  if (ratio <= kUsualBorderRatio) return;
  observer.note(
      fmt::format("borders are {:.2f} times as long as the bisectors (usually at most {}): no shorter ones were found "
                  "along edges near these; \1cut\2 follows the bisectors",
                  ratio, kUsualBorderRatio));
}

/// With levels, adds the labels of the last one.
void add_labels(const PartedMesh& parted, const IdVector<FaceId, GeneratorId>& labels,
                std::vector<FaceNumbers>& numbers) {
  if (parted.levels > 0) numbers.push_back({level_name(parted.levels), to_regions(labels)});
}

void label_whole_faces(const SegmentCall& call, Observer& observer, SegmentOutcome& outcome) {
  const SegmentOptions options{call.segmentation.labels, progress_of(observer)};
  const Mesh& surface = outcome.surface();
  outcome.whole = as_step(observer, "segment", [&] { return segment_faces(surface, *outcome.diagram, options); });
  const IdVector<FaceId, GeneratorId>& labels = outcome.whole->face_label;
  outcome.border_length = compute_border_length(surface, labels);
  outcome.whole_numbers = outcome.parted.numbers;
  add_labels(outcome.parted, labels, outcome.whole_numbers);
  const double ratio = tell_segmentation(observer, outcome);
  outcome.unreached_faces = note_unreached(observer, outcome);
  if (options.labels == FaceLabels::smooth) note_long_borders(observer, ratio);
  if (!call.disc) return;
  note_non_discs(observer, outcome.input->mesh, labels, "whole faces join or touch there; \1cut\2 follows the cells");
}

void tell_charts(Observer& observer, const Charts& charts, ChartMap map) {
  const auto percent = [&](double Chart::*area_of) { return fmt::format("{:.3g} %", 100 * charts.share(area_of)); };
  const auto has = [&](double Chart::*area_of) { return charts.share(area_of) > 0; };
  const bool is_flat = map == ChartMap::flat;
  observer.note(fmt::format("{} {:.3g} % of the texture{}",
                            counted(std::ssize(charts.charts), "chart covers", "charts cover"), 100 * charts.covered,
                            is_flat && !has(&Chart::flipped_area) ? "; no face is flipped" : ""));
  if (has(&Chart::flipped_area)) {
    observer.note(fmt::format("{} of the area is flipped{}", percent(&Chart::flipped_area),
                              is_flat ? ": limbs too long for double precision; give more generators"
                                      : " where shortest paths meet, or flat behind saddles; \1uv=flat\2 flips "
                                        "none"));
  }
  if (has(&Chart::torn_area)) {
    observer.note(fmt::format("{} of the area is torn off its chart, where shortest paths come from two sides",
                              percent(&Chart::torn_area)));
  }
  if (has(&Chart::unplaced_area)) {
    observer.note(fmt::format("{} of the area has no texture coordinates: no path to its generator was found",
                              percent(&Chart::unplaced_area)));
  }
}

Charts chart(const SegmentCall& call, Observer& observer, const SegmentOutcome& outcome, const CutMesh& cut) {
  const ChartOptions options{*call.uv, observer.threads, progress_of(observer)};
  Charts charts =
      as_step(observer, "charts", [&] { return make_charts(outcome.surface(), *outcome.diagram, cut, options); });
  tell_charts(observer, charts, *call.uv);
  return charts;
}

/// Cuts the input and not the diagram's surface: both sides of a border keep their vertices in common.
void cut_along_bisectors(const SegmentCall& call, Observer& observer, SegmentOutcome& outcome) {
  const Mesh& input = outcome.input->mesh;
  auto cut = std::make_shared<CutMesh>(
      as_step(observer, "cut", [&] { return cut_faces(input, *outcome.diagram, progress_of(observer)); }));
  outcome.cut_vertices = carry_to_cut_vertices(outcome.surface(), *outcome.diagram, *cut);
  cut->numbers = carry_to_cut_faces(outcome.parted.numbers, *cut);
  outcome.appearance = carry_to_cut_faces(input, outcome.input->appearance, *cut);
  add_labels(outcome.parted, cut->label, cut->numbers);
  if (cut->uncut_faces > 0) {
    observer.note(fmt::format("{} could not be cut", counted(cut->uncut_faces, "face", "faces")));
  }
  outcome.cut = cut;
  outcome.unreached_faces = note_unreached(observer, outcome);
  if (call.disc) note_non_discs(observer, cut->mesh, cut->label, "the given regions touch themselves there");
  if (!call.uv) return;
  outcome.charts = chart(call, observer, outcome, *cut);
  outcome.chart_map = *call.uv;
  replace_texture(std::exchange(outcome.charts->texture, {}), outcome.appearance);
}

/// Throws Error{invalid_option} where generators can't be added to the diagram until its cells are discs.
void check_discs(const DiagramObject& on) {
  const char* const why = !on.options()                   ? "the diagram keeps to regions"
                          : !on.diagram().curves.empty()  ? "the generators are curves"
                          : !on.diagram().weights.empty() ? "the generators have weights"
                                                          : nullptr;
  if (why == nullptr) return;
  throw Error(ErrorCode::invalid_option,
              fmt::format("\1disc\2: {}, so that no generators can be added; leave it out", why));
}

// ---- words for users

void describe_regions(OptionList& list, SegmentCall& call) {
  describe(list, call.regions, "regions and distances");
  list.option("per_region", Number{&call.per_region, {.least = 1}},
              {.help = "Number of generators to sample in each region of \1within\2"});
  list.option(
      "levels", Counts{&call.levels},
      {.help = "Segment several times, each inside the regions of the time before",
       .more = ": the numbers of generators, as in 10,100,1000; \1cut\2 cuts along those of the last level",
       .arrays = "Segment several times, each inside the regions of the time before: the numbers of generators, "
                 "ascending; \1cut\2 cuts along those of the last level"});
  list.needs("per_region", "within");
}

}  // namespace

void SegmentCall::complete() {
  generators.implied_count = levels.empty() ? per_region : levels.back();
  cut = cut || uv.has_value();
}

void describe(OptionList& list, LabelCall& call) {
  list.group("Regions");
  list.option("cut", Flag{&call.cut},
              {.help = "Split faces along the bisectors instead of labelling whole faces", .shown = Shown::main});
  describe(list, call.segmentation);
  list.option(
      "uv", choice(call.uv, kChartMapNames),
      {.help =
           "Give each region texture coordinates, in a " + list_extensions(output_extensions(Content::texture), "or"),
       .more = ": distance and direction from its generator, or a map that flips no face and needs discs (implies "
               "\1cut\2)"});
  list.option("disc", Flag{&call.disc}, {.help = "Add generators, as few as are found, until every region is a disc"});
  list.excludes("cut", {"labels"});
  list.excludes("uv", {"labels"});
  list.rule({"labels", {"cut", "uv"}, [&call](const Given&) -> std::string {
               return call.cut || call.uv ? "\1labels\2: no whole face is labelled; leave it out" : "";
             }});
}

void describe(OptionList& list, SegmentCall& call) {
  describe(list, call.generators, {"curves", "per_region", "levels"});
  describe(list, call.diagram);
  describe(list, static_cast<LabelCall&>(call));
  describe_regions(list, call);
  describe(list, call.weights, call.diagram);
  describe_curves(list, call.generators);
  list.excludes("disc", {"balance", "weights"}, "a generator that is added has no weight");
  list.excludes("curves", {"sampling", "seed", "merge_coincident"});
  list.excludes("curves", {"disc"}, "the cell of a closed curve is no disc, however many generators are added");
  list.excludes("curves", {"uv"}, "charts are laid around points");
  exclude_curves(list);
  list.rule({"curves", {"method"}, [&call](const Given&) -> std::string {
               return call.diagram.method == Method::exact ? "" : "\1curves\2 needs \1method=exact\2";
             }});
}

std::shared_ptr<const SegmentOutcome> run(const DiagramObject& on, LabelCall& call, Observer& observer) {
  if (call.uv && !on.diagram().curves.empty()) {
    throw Error(ErrorCode::invalid_option,
                "\1uv\2: the generators are curves, and charts are laid around points; leave it out, or take a diagram "
                "of points");
  }
  SegmentCall whole;  // regions and levels are those of the diagram
  static_cast<LabelCall&>(whole) = call;
  whole.complete();
  call.cut = whole.cut;
  auto outcome = std::make_shared<SegmentOutcome>();
  outcome->input = on.mesh();
  outcome->diagram = on.shared();
  outcome->options = on.options();
  if (on.parted().mesh) {
    outcome->parted = *on.parted().mesh;
    outcome->diagram = on.parted().diagram;
  }
  if (call.disc) {
    check_discs(on);
    whole.diagram = *on.options();
    whole.diagram.threads = observer.threads;
    outcome->diagram = std::make_shared<const Diagram>(make_cells_discs(whole, observer, *outcome->diagram, *outcome));
  }
  outcome->on_input = outcome->parted.on_input(outcome->diagram);
  call.cut ? cut_along_bisectors(whole, observer, *outcome) : label_whole_faces(whole, observer, *outcome);
  return outcome;
}

std::shared_ptr<const SegmentOutcome> run(const MeshPtr& input, SegmentCall& call, Observer& observer) {
  call.diagram.threads = observer.threads;
  call.complete();
  auto outcome = std::make_shared<SegmentOutcome>();
  outcome->input = input;
  outcome->parted = part(*input, call, observer);
  Diagram diagram;
  if (call.generators.curves.is_given()) {
    diagram = compute_of_curves(*input, call.generators, call.diagram, observer);
  } else {
    ResolvedGenerators found =
        choose_inside(*input, outcome->parted, call.generators, call.diagram, call.per_region.has_value(), observer);
    outcome->snap_distance = std::move(found.snap_distance);
    diagram = compute_weighted(*input, outcome->surface(), found.points, call.weights, call.diagram, observer,
                               outcome->balanced);
  }
  if (call.disc) diagram = make_cells_discs(call, observer, diagram, *outcome);
  outcome->diagram = outcome->on_input = std::make_shared<const Diagram>(std::move(diagram));
  outcome->on_input = outcome->parted.on_input(outcome->diagram);
  call.cut ? cut_along_bisectors(call, observer, *outcome) : label_whole_faces(call, observer, *outcome);
  resolve(call.diagram);
  if (!outcome->parted.is_parted()) outcome->options = call.diagram;
  return outcome;
}

}  // namespace gvd
