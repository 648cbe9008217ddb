// The operations `label` and `segment`: find regions, compute a diagram inside them, and label or cut the faces by its
// cells.
//
// Either whole faces get the label of a cell, so that borders run along edges, or the faces are split along the
// bisectors, and each new face knows its parent (gvd/segment.hpp). Each level except the last labels whole faces, and
// its labels are the regions of the next level. The first level keeps to the given regions; a mask takes faces out of
// the regions or out of the whole surface. All results have the input's faces or pieces of them, and its vertices.

#include "gvd/segment_operation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <set>
#include <utility>

#include "figures.hpp"
#include "gvd/barriers.hpp"
#include "gvd/diagram_options.hpp"
#include "gvd/diagram_parts.hpp"
#include "gvd/disc_cells.hpp"
#include "gvd/error.hpp"
#include "gvd/io/format.hpp"
#include "gvd/io/label_color.hpp"
#include "gvd/segment_options.hpp"
#include "gvd/text.hpp"

namespace gvd {
namespace {

/// A note names at most this many generators or regions.
constexpr std::size_t kNamed = 8;

/// Borders longer than this multiple of the bisectors' length get a note, because the mesh is probably too coarse. 491
/// of 509 runs with at least 50 faces for each generator stay below it (docs/developer/segment-borders.md).
constexpr double kUsualBorderRatio = 1.14;

/// The first ids, followed by "..." if there are more.
std::string name_some(const std::vector<GeneratorId>& ids) {
  std::vector<std::int32_t> named;
  for (std::size_t i = 0; i < std::min(kNamed, ids.size()); ++i) named.push_back(ids[i].value());
  return fmt::format("{}{}", fmt::join(named, ", "), named.size() < ids.size() ? ", ..." : "");
}

// ---- the regions

// A level needs no figures of its own, because a segmentation with its number of generators has the same figures.
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

Diagram make_cells_discs(const SegmentCall& call, Observer& observer, const Mesh& surface, const Diagram& diagram,
                         SegmentOutcome& outcome) {
  DiscOptions options;
  options.diagram = call.diagram;
  options.diagram.progress = progress_of(observer);
  DiscCells made = as_step(observer, "discs", [&] { return make_discs(surface, diagram, options); });
  outcome.discs = {made.added, made.rounds, made.search_cut_short};
  if (made.added > 0) {
    outcome.snap_distance.resize(made.diagram.generators.size());
    observer.note(fmt::format("{} added, so that every cell is a disc{}",
                              counted(made.added, "generator was", "generators were"),
                              made.search_cut_short ? "; fewer may be enough" : ""));
    tell_diagram(observer, made.diagram);
  }
  return std::move(made.diagram);
}

// ---- the faces

void note_non_discs(Observer& observer, const Mesh& mesh, const IdVector<FaceId, GeneratorId>& label, const char* why) {
  const std::vector<GeneratorId> regions = find_non_disc_regions(mesh, label);
  if (regions.empty()) return;
  observer.note(fmt::format("{}: {}; {}",
                            counted(std::ssize(regions), "region is not a disc, although its cell is",
                                    "regions are not discs, although their cells are"),
                            name_some(regions), why));
}

/// Notes the faces that no generator reaches, and why. Returns their number.
std::int64_t note_unreached(Observer& observer, const SegmentOutcome& outcome) {
  const IdVector<FaceId, GeneratorId>& label = outcome.face_labels();
  std::vector<FaceId> reached, unreached;  // faces of the input
  for (const FaceId f : label.ids()) {
    const FaceId whole = outcome.cut ? outcome.cut->parent[f] : f;
    if (!outcome.parted().is_left_out(whole)) (label[f].valid() ? reached : unreached).push_back(whole);
  }
  if (unreached.empty()) return 0;
  const Barriers barriers(outcome.input());
  const Barriers::Origin origin = barriers.from(reached);
  BarrierCounts counts;
  for (const FaceId f : unreached) counts.add(barriers.between(origin, f));
  observer.note(fmt::format("{} reached by no generator and {} label -1: {}",
                            counted(std::ssize(unreached), "face is", "faces are"),
                            unreached.size() == 1 ? "gets" : "get", counts.describe("in another region")));
  return std::ssize(unreached);
}

/// Notes generators without a face. Returns the length of the borders divided by the length of the bisectors; 0 without
/// bisectors.
double tell_segmentation(Observer& observer, const SegmentOutcome& outcome) {
  const std::vector<GeneratorId>& without = outcome.whole->without_face;
  if (!without.empty()) {
    observer.note(fmt::format("{} inside faces of other regions: {}",
                              counted(std::ssize(without), "generator owns no face, its cell lies",
                                      "generators own no face, their cells lie"),
                              name_some(without)));
  }
  const double bisectors = outcome.of_surface().length;
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
      fmt::format("borders are {:.2f} times as long as the bisectors (usually at most {}): no shorter borders "
                  "were found along nearby edges; \1cut\2 follows the bisectors",
                  ratio, kUsualBorderRatio));
}

/// With levels, adds the labels of the last level.
void add_labels(const PartedMesh& parted, const IdVector<FaceId, GeneratorId>& labels,
                std::vector<FaceNumbers>& numbers) {
  if (parted.levels > 0) numbers.push_back({level_name(parted.levels), to_regions(labels)});
}

void label_whole_faces(const SegmentCall& call, Observer& observer, SegmentOutcome& outcome) {
  const SegmentOptions options{call.segmentation.labels, progress_of(observer)};
  const Mesh& surface = outcome.surface();
  outcome.whole = as_step(observer, "segment", [&] { return segment_faces(surface, outcome.of_surface(), options); });
  const IdVector<FaceId, GeneratorId>& labels = outcome.whole->face_label;
  outcome.border_length = compute_border_length(surface, labels);
  outcome.whole_numbers = outcome.parted().numbers;
  add_labels(outcome.parted(), labels, outcome.whole_numbers);
  const double ratio = tell_segmentation(observer, outcome);
  outcome.unreached_faces = note_unreached(observer, outcome);
  if (options.labels == FaceLabels::smooth) note_long_borders(observer, ratio);
  if (!call.disc) return;
  note_non_discs(observer, outcome.input().mesh, labels, "whole faces join or touch there; \1cut\2 follows the cells");
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
  if (is_flat && charts.flipped_by_floats > 0) {
    observer.detail(
        fmt::format("{} flipped in .glb, which rounds texture coordinates to 32-bit floats; .ply and .obj "
                    "keep doubles, and flip none",
                    counted(charts.flipped_by_floats, "face is", "faces are")));
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
      as_step(observer, "charts", [&] { return make_charts(outcome.surface(), outcome.of_surface(), cut, options); });
  tell_charts(observer, charts, *call.uv);
  return charts;
}

/// Cuts the input and not the diagram's surface, so that both sides of a border share their vertices.
void cut_along_bisectors(const SegmentCall& call, Observer& observer, SegmentOutcome& outcome) {
  const Mesh& input = outcome.input().mesh;
  auto cut = std::make_shared<CutMesh>(
      as_step(observer, "cut", [&] { return cut_faces(input, outcome.of_surface(), progress_of(observer)); }));
  outcome.cut_vertices = carry_to_cut_vertices(outcome.surface(), outcome.of_surface(), *cut);
  cut->numbers = carry_to_cut_faces(outcome.parted().numbers, *cut);
  outcome.appearance = carry_to_cut_faces(input, outcome.input().appearance, *cut);
  add_labels(outcome.parted(), cut->label, cut->numbers);
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

/// Throws Error{invalid_option} if generators can't be added to the diagram until its cells are discs.
void check_discs(const DiagramObject& on) {
  const char* const why = !on.options()                   ? "the diagram keeps to regions"
                          : !on.diagram().curves.empty()  ? "the generators are curves"
                          : !on.diagram().weights.empty() ? "the generators have weights"
                                                          : nullptr;
  if (why == nullptr) return;
  throw Error(ErrorCode::invalid_option,
              fmt::format("\1disc\2: {}, so that no generators can be added; leave it out", why));
}

// ---- descriptions for users

void describe_regions(OptionList& list, SegmentCall& call) {
  describe(list, call.regions, "regions and distances");
  list.option("per_region", Number{&call.per_region, {.least = 1}},
              {.help = "Number of generators to sample in each region of \1within\2"});
  list.option(
      "levels", Counts{&call.levels},
      {.help = "Segment several times, each time inside the regions of the previous level",
       .more = ": the numbers of generators, as in 10,100,1000; \1cut\2 cuts along those of the last level",
       .arrays =
           "Segment several times, each time inside the regions of the previous level: the numbers of generators, "
           "ascending; \1cut\2 cuts along those of the last level"});
  list.needs("per_region", "within");
}

// ---- the parts of the result

/// Adds the figures of labelled whole faces.
void add_whole(const Figures& figure, const SegmentOutcome& made) {
  const Segmentation& whole = or_none(made.whole);
  figure("generators_without_face", "", "whose cells lie inside faces of others", each_of(whole.without_face));
  figure("moved_faces", "", "labelled with a cell that has not the largest share, to connect regions",
         whole.moved_faces);
  figure("given_faces", "", "given to generators that would own none", whole.given_faces);
  figure("smoothed_faces", "", "with another label than the nearest one has", whole.smoothed_faces);
  figure("border_length", "mesh units", "of the edges between regions", made.border_length);
  const double bisectors = made.of_surface().length;
  figure("border_ratio", "", "that length by that of the bisectors",
         bisectors > 0 ? Figure(made.border_length / bisectors) : Figure());
}

Table list_regions(const SegmentOutcome& made) {
  const std::vector<SurfacePoint>& generators = made.of_surface().generators;
  const Mesh& mesh = made.cut ? made.cut->mesh : made.input().mesh;
  const IdVector<GeneratorId, RegionSize> sizes = measure_regions(mesh, made.face_labels(), generators.size());
  Table table{{"label", each_of(sizes.ids())}};
  for (const FaceNumbers& numbers : made.parted().numbers) {
    table.push_back({numbers.name, each_of(generators, [&](const auto& point) { return numbers.values[point.face]; })});
  }
  table.push_back({"faces", each_of(sizes, &RegionSize::faces)});
  table.push_back({"area", each_of(sizes, &RegionSize::area)});
  return table;
}

std::vector<double> box_of(const Chart& chart) {
  if (chart.box.isEmpty()) return {};
  return {chart.box.min().x(), chart.box.min().y(), chart.box.max().x(), chart.box.max().y()};
}

Table list_charts(const std::vector<Chart>& charts, ChartMap map) {
  const auto share_of = [&](double Chart::*part) {
    return each_of(charts, [part](const Chart& chart) { return chart.area > 0 ? chart.*part / chart.area : 0; });
  };
  Table table{{"label", each_of(charts, &Chart::generator)}, {"faces", each_of(charts, &Chart::faces)},
              {"area", each_of(charts, &Chart::area)},       {"flipped_share", share_of(&Chart::flipped_area)},
              {"stretch", each_of(charts, &Chart::stretch)}, {"box", each_of(charts, box_of)}};
  if (map == ChartMap::flat) return table;
  table.push_back({"torn_share", share_of(&Chart::torn_area)});
  table.push_back({"origin", each_of(charts, [](const Chart& chart) {
                     return std::vector<double>{chart.origin.x(), chart.origin.y()};
                   })});
  return table;
}

void add_charts(ObjectVisitor& visitor, const SegmentOutcome& made) {
  const Figures figure(visitor, "charts", made.charts.has_value());
  const Charts& charts = or_none(made.charts);
  figure("scale", "texture units per mesh unit", "of all charts", charts.scale);
  figure("covered_share", "", "of the texture", charts.covered);
  figure("flipped_share", "", "of the area: faces that are flipped", charts.share(&Chart::flipped_area));
  figure("flipped_by_floats", "", "faces that are flipped in .glb alone, whose texture coordinates are 32-bit floats",
         charts.flipped_by_floats);
  figure("torn_share", "", "of the area: faces that are torn off", charts.share(&Chart::torn_area));
  figure("unplaced_share", "", "of the area: faces without texture coordinates", charts.share(&Chart::unplaced_area));
  visitor.table({"charts.charts", "", "the connected parts of regions"}, list_charts(charts.charts, made.chart_map));
}

/// Makes an object of the labels' colours in sRGB, 0 to 255; the last one is the colour of no label.
std::shared_ptr<const Object> make_colors(const LabelledMesh& mesh) {
  std::vector<Rgb> colors = region_colors(mesh);
  colors.push_back(kUnlabelledColor);
  return std::make_shared<PlainObject>("colors", [colors = std::move(colors)](ObjectVisitor& visitor) {
    visitor.array({"colors", "", "red, green and blue"},
                  {colors.data(), ArrayType::uint8, 2, {std::ssize(colors), 3}, {sizeof(Rgb), 1}});
  });
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
  list.excludes("curves", {"disc"}, "the cell of a closed curve is not a disc, however many generators are added");
  list.excludes("curves", {"uv"}, "charts need points as generators");
  describe_curve_rules(list, call.diagram);
}

std::shared_ptr<const SegmentOutcome> run(const DiagramObject& on, LabelCall& call, Observer& observer) {
  if (call.uv && !on.diagram().curves.empty()) {
    throw Error(ErrorCode::invalid_option,
                "\1uv\2: the generators are curves, and charts need points; leave it out, or take a diagram of "
                "points");
  }
  SegmentCall whole;  // without regions and levels, which the diagram has already
  static_cast<LabelCall&>(whole) = call;
  whole.complete();
  call.cut = whole.cut;
  auto outcome = std::make_shared<SegmentOutcome>();
  outcome->diagram = std::make_shared<DiagramObject>(on);
  if (call.disc) {
    check_discs(on);
    whole.diagram = *on.options();
    whole.diagram.threads = observer.threads;
    auto discs =
        std::make_shared<const Diagram>(make_cells_discs(whole, observer, on.surface(), *on.of_surface(), *outcome));
    outcome->diagram = std::make_shared<DiagramObject>(on.mesh(), std::move(discs), on.options());
  }
  call.cut ? cut_along_bisectors(whole, observer, *outcome) : label_whole_faces(whole, observer, *outcome);
  return outcome;
}

std::shared_ptr<const SegmentOutcome> run(const MeshPtr& input, SegmentCall& call, Observer& observer) {
  call.diagram.threads = observer.threads;
  call.complete();
  auto outcome = std::make_shared<SegmentOutcome>();
  const auto parted = std::make_shared<PartedMesh>(part(*input, call, observer));
  ResolvedGenerators found;
  auto diagram = std::make_shared<Diagram>(
      compute_parts(*input, *parted, call, call.per_region.has_value(), observer, found, outcome->balanced));
  outcome->snap_distance = std::move(found.snap_distance);
  if (call.disc) *diagram = make_cells_discs(call, observer, parted->surface(input->mesh), *diagram, *outcome);
  resolve(call.diagram);
  outcome->diagram = std::make_shared<DiagramObject>(input, std::move(diagram), call.diagram, parted);
  call.cut ? cut_along_bisectors(call, observer, *outcome) : label_whole_faces(call, observer, *outcome);
  return outcome;
}

const IdVector<FaceId, GeneratorId>& SegmentOutcome::face_labels() const {
  static const IdVector<FaceId, GeneratorId> kNone;
  return cut ? cut->label : whole ? whole->face_label : kNone;
}

std::optional<LabelledMesh> SegmentOutcome::labelled() const {
  if (!cut) {
    LabelledMesh mesh = label_mesh(input().mesh, diagram->diagram(), whole->face_label);
    mesh.diagram = &of_surface();
    mesh.diagram_mesh = &surface();
    mesh.face_numbers = &whole_numbers;
    mesh.appearance = &input().appearance;
    return mesh;
  }
  LabelledMesh mesh{cut->mesh,     &cut->label, &cut->parent, &cut_vertices.label, &cut_vertices.distance,
                    &of_surface(), &surface()};
  mesh.face_numbers = &cut->numbers;
  mesh.appearance = &appearance;
  return mesh;
}

std::vector<std::vector<Vec3>> SegmentOutcome::borders() const {
  std::vector<std::vector<Vec3>> borders;
  const Mesh& mesh = input().mesh;
  const FaceRegions& regions = parted().regions;
  if (regions.empty()) return borders;
  for (const EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e), twin = mesh.twin(h);
    if (!twin.valid() || regions[Mesh::face(h)] == regions[Mesh::face(twin)]) continue;
    borders.push_back({mesh.position(mesh.from(h)), mesh.position(mesh.to(h))});
  }
  return borders;
}

void SegmentOutcome::check_file(const WrittenFile& file) const {
  if (!charts || has_any(file.format->carries, Content::texture)) return;
  throw Error(ErrorCode::invalid_option, fmt::format("\1uv\2: {} texture coordinates; write one or leave \1uv\2 out",
                                                     only_formats(Content::texture)));
}

OwnWriters SegmentOutcome::own_writers() const {
  return {{"json", [this](std::ostream& out) {
             if (cut) return write_cut_json(out, input().mesh, diagram->diagram(), *cut, cut_vertices);
             write_segmentation_json(out, input().mesh, diagram->diagram(), *whole, whole_numbers);
           }}};
}

void SegmentOutcome::visit(ObjectVisitor& visitor) const {
  const Mesh& mesh = cut ? cut->mesh : input().mesh;
  const Diagram& on_input = diagram->diagram();
  visit_parted(visitor, parted());
  visit_balance(visitor, balanced);
  const Figures figure(visitor), disc(visitor, "disc", discs.has_value());
  figure("weights", "mesh units", "of the generators, where there are any",
         on_input.weights.empty() ? Figure() : Figure(on_input.weights));
  disc("added", "", "generators, so that every cell is a disc", or_none(discs).added);
  disc("rounds", "", "diagrams to which generators were added", or_none(discs).rounds);
  disc("search_cut_short", "", "whether fewer may be enough", or_none(discs).search_cut_short);
  figure("uncut_faces", "", "that could not be cut", cut ? Figure(plain(cut->uncut_faces)) : Figure());
  add_whole(Figures(visitor, "", whole.has_value()), *this);
  figure("faces", "", "of the labelled mesh", mesh.face_count());
  figure("unreached_faces", "", "that no generator reaches", unreached_faces);
  visitor.table({"regions", "", "faces and area of each label"}, list_regions(*this));
  add_charts(visitor, *this);

  visitor.points({"generators", "", "by their labels"}, on_input.generators);
  visitor.array({"face_labels", "", "the region of each face, or of each piece; -1: none"}, view(face_labels()));
  const IdVector<FaceId, FaceId> no_parents;
  visitor.array({"face_parents", "", "parent face of each piece, in the input; empty without cut"},
                view(cut ? cut->parent : no_parents));
  visitor.array({"vertex_labels", "", "the nearest generator of each vertex; -1: none"},
                view(cut ? cut_vertices.label : on_input.vertex_label));
  visitor.array({"vertex_distances", "mesh units", "the distance from it"},
                view(cut ? cut_vertices.distance : on_input.vertex_distance));
  for (const FaceNumbers& numbers : this->numbers()) {
    visitor.array({numbers.name, "", "of each face: its region, or its label at that level"}, view(numbers.values));
  }
  static const std::vector<Uv> kNone;
  visitor.array({"texture", "", "u and v of the three corners of each piece; empty without uv"},
                view(charts ? appearance.texture : kNone));
  visitor.part({"diagram", "", "of the generators, with the vertices of the input"}, "diagram",
               [this] { return diagram; });
  visitor.part({"colors", "", "of the labels, as in files and on pages; that of no label follows"}, "colors",
               [this]() -> std::shared_ptr<const Object> {
                 if (const auto shown = labelled()) return make_colors(*shown);
                 return nullptr;
               });
  visitor.part({"cut_mesh", "", "the pieces of the faces, made with cut"}, "mesh",
               [this]() -> std::shared_ptr<const Object> {
                 if (!cut) return nullptr;
                 auto pieces = std::make_shared<CheckedMesh>(as_input(cut->mesh));
                 pieces->appearance = appearance;
                 return std::make_shared<MeshObject>(std::move(pieces));
               });
}

}  // namespace gvd
