// A diagram that follows changes of its generators.
//
// A change of one generator leaves most windows, crossings and arcs as they are. `EditableWindows` finds the faces
// whose windows change, and `RetracingTracer` traces these faces again. Labels, bisectors and cells are then collected
// as in `compute_diagram`. Outside the neighbourhood of the change, data is only copied and counted: the working mesh,
// the lists of crossings and arcs, the sums of the cells. With a hundred generators, this takes most of the time.
// When a generator is removed, the last generator gets its number. Otherwise all later numbers would change, and with
// them the ties that numbers decide.
// Source: none.
// Invariant: the diagram is that of `compute_diagram` with the same generators, except where shortest paths tie to the
// last bit.
#include "gvd/diagram_editor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

#include "base/sort_unique.hpp"
#include "diagram/diagram_windows.hpp"
#include "diagram/envelope/retrace_envelope.hpp"
#include "diagram/finish_diagram.hpp"
#include "geodesic/symbolic_offset.hpp"
#include "geodesic/windows/propagation/window_updates.hpp"
#include "geodesic/windows/window_sources.hpp"
#include "gvd/diagram_steps.hpp"
#include "gvd/error.hpp"
#include "gvd/text.hpp"
#include "mesh/common_elements.hpp"

namespace gvd {

namespace {

/// The vertices of the changed faces, ascending.
std::vector<VertexId> vertices_of(const Mesh& mesh, const std::vector<FaceId>& faces) {
  std::vector<VertexId> vertices;
  for (const FaceId f : faces) vertices.insert(vertices.end(), mesh.vertices(f).begin(), mesh.vertices(f).end());
  sort_unique(vertices);
  return vertices;
}

/// The labels of the windows. Only vertices near the change are tested for support.
NearestLabels labels_of(const WorkingMesh& working, const WindowField& windows, const KnownTrace& known) {
  std::vector<VertexId> before;  // input vertices keep their numbers; inserted ones are generators, or have changed
  const auto is_of_input = [&](VertexId v) { return v.value() < working.input().vertex_count(); };
  std::ranges::copy_if(known.traced.nearest().unsupported, std::back_inserter(before), is_of_input);
  return take_labels(working, windows.distance, windows.label, before, vertices_of(working.mesh(), known.changed));
}

/// Whether crossings can stay because their symbolic offsets are the same for both numbers of generators.
bool have_same_offsets(const Mesh& mesh, std::size_t before, std::size_t after) {
  const double diagonal = mesh.bbox_diagonal();
  return SymbolicOffset::of_envelope(diagonal, before).step == SymbolicOffset::of_envelope(diagonal, after).step;
}

}  // namespace

struct DiagramEditor::State {
  State(const Mesh& of_mesh, DiagramOptions all_options) : mesh(of_mesh), options(std::move(all_options)) {}

  void check(GeneratorId g) const;
  void compute(std::vector<SurfacePoint> generators);
  void change(std::vector<SurfacePoint> generators, const ChangedGenerators& changed);
  void take(std::unique_ptr<WorkingMesh> new_working, TracedDiagram new_traced, Diagram next);

  const Mesh& mesh;
  DiagramOptions options;
  std::unique_ptr<WorkingMesh> working;
  std::unique_ptr<EditableWindows> windows;
  TracedDiagram traced{};
  Diagram diagram{};
  std::int32_t propagated = 0;
  bool is_current = false;  ///< whether the windows are those of the diagram; false after an interruption
};

void DiagramEditor::State::check(GeneratorId g) const {
  const std::vector<SurfacePoint>& points = diagram.generators;
  if (g.valid() && g.index() < points.size()) return;
  throw Error(ErrorCode::precondition,
              fmt::format("there is no generator {}; the diagram has {}", g.value(),
                          counted(std::ssize(points), "generator", "generators")),
              g.value());
}

/// Takes over the result of a change. Throws nothing.
void DiagramEditor::State::take(std::unique_ptr<WorkingMesh> new_working, TracedDiagram new_traced, Diagram next) {
  working = std::move(new_working);
  traced = std::move(new_traced);
  diagram = std::move(next);
  is_current = true;
}

/// Computes everything from scratch. The state changes only after the last step that can throw.
void DiagramEditor::State::compute(std::vector<SurfacePoint> generators) {
  auto after = std::make_unique<WorkingMesh>(mesh, generators, options.progress);
  auto new_windows = std::make_unique<EditableWindows>(*after, options.threads, options.progress);
  const WindowField& field = new_windows->field();
  const ParallelChunks parallel(options.threads, options.progress);
  const WindowDistances distances(after->mesh(), field);
  EnvelopeTracer tracer(*after, distances, chord_length(after->mesh(), options), parallel);
  TracedDiagram new_traced =
      trace_connected(*after, take_labels(*after, field.distance, field.label, parallel), tracer, options.progress);
  Diagram next;
  next.generators = std::move(generators);
  next.report.propagation_events = field.carried;
  finish_diagram(*after, new_traced, parallel, next);
  windows = std::move(new_windows);
  propagated = static_cast<std::int32_t>(next.generators.size());
  take(std::move(after), std::move(new_traced), std::move(next));
}

/// If the generators are refused, this throws before the windows change. An interruption loses the windows, so that the
/// next change starts from scratch.
void DiagramEditor::State::change(std::vector<SurfacePoint> generators, const ChangedGenerators& changed) {
  auto after = std::make_unique<WorkingMesh>(mesh, generators, options.progress);
  if (!std::exchange(is_current, false)) return compute(std::move(generators));
  const CommonElements common = find_common_elements(*working, *after, changed);
  WindowChange update = windows->update({*working, *after, common, changed}, options.progress);
  if (!have_same_offsets(mesh, diagram.generators.size(), generators.size())) {
    update.is_changed.assign(update.is_changed.size(), 1);  // not `changed`, because labels are the same elsewhere
  }
  const KnownTrace known{working->mesh(), traced, common, update.is_changed, update.changed};
  const WindowField& field = windows->field();
  const ParallelChunks parallel(options.threads, options.progress);
  const WindowDistances distances(after->mesh(), field);
  const EnvelopeTracer tracer(*after, distances, chord_length(after->mesh(), options), parallel);
  RetracingTracer retracing(tracer, *after, field, known);
  TracedDiagram new_traced = trace_connected(*after, labels_of(*after, field, known), retracing, options.progress);
  Diagram next;
  next.generators = std::move(generators);
  next.report.propagation_events = field.carried;
  report_progress(options.progress, steps::kCells, 0);
  // From here on, pieces move out of the present diagram. No progress is reported, so that nothing can interrupt.
  const Progress silent;
  KnownPieces pieces{retracing.take_kept(), diagram.pieces};
  finish_diagram(*after, new_traced, ParallelChunks(options.threads, silent), next, &pieces);
  propagated = update.propagated;
  take(std::move(after), std::move(new_traced), std::move(next));
}

DiagramEditor::DiagramEditor(const Mesh& mesh, std::vector<SurfacePoint> generators, DiagramOptions options) {
  check_diagram_options(options);
  if (options.method != Method::exact) {
    throw Error(ErrorCode::invalid_option, "only diagrams of the exact method can be edited");
  }
  if (!options.weights.empty()) throw Error(ErrorCode::invalid_option, "a diagram with weights can't be edited");
  state_ = std::make_unique<State>(mesh, std::move(options));
  state_->compute(std::move(generators));
}

DiagramEditor::~DiagramEditor() = default;
DiagramEditor::DiagramEditor(DiagramEditor&&) noexcept = default;
DiagramEditor& DiagramEditor::operator=(DiagramEditor&&) noexcept = default;

const Diagram& DiagramEditor::diagram() const { return state_->diagram; }
std::int32_t DiagramEditor::propagated() const { return state_->propagated; }

void DiagramEditor::run_with(int threads, Progress progress) {
  state_->options.threads = threads;
  state_->options.progress = std::move(progress);
  state_->windows->run_with(threads);
}

const Diagram& DiagramEditor::move(GeneratorId g, const SurfacePoint& to) {
  state_->check(g);
  std::vector<SurfacePoint> points = generators();
  const SurfacePoint from = std::exchange(points[g.index()], to);
  state_->change(std::move(points), {{g}, {g}, {from, to}});
  return diagram();
}

const Diagram& DiagramEditor::add(const std::vector<SurfacePoint>& points) {
  std::vector<SurfacePoint> all = generators();
  ChangedGenerators changed{{}, {}, points};
  for (const SurfacePoint& point : points) {
    changed.after.emplace_back(all.size());
    all.push_back(point);
  }
  state_->change(std::move(all), changed);
  return diagram();
}

const Diagram& DiagramEditor::remove(GeneratorId g) {
  state_->check(g);
  std::vector<SurfacePoint> points = generators();
  if (points.size() == 1) {
    throw Error(ErrorCode::precondition,
                "generator 0 is the only one, and a diagram needs one; move it, or add another first", 0);
  }
  const GeneratorId last(points.size() - 1);
  ChangedGenerators changed{{g}, {}, {points[g.index()]}};
  if (g != last) {
    changed.before.push_back(last);
    changed.after.push_back(g);
    changed.points.push_back(points.back());
  }
  points[g.index()] = points.back();
  points.pop_back();
  state_->change(std::move(points), changed);
  return diagram();
}

}  // namespace gvd
