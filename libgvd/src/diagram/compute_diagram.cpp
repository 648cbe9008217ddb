// The whole pipeline: a working mesh, in which every generator is a vertex; distances by the solver; bisectors by the
// tracer, in rounds that connect every cell; and the cells.
//
// Any solver works with any tracer. The envelope tracer reads a `DistanceField`, and the tracers of the paper read the
// generator tables of the faces. Each solver provides both. The steps after the tracer are the same for all methods.
// Source: section 4 of the paper, whose steps `Method::paper` keeps one by one. The paper's complexity is O((n + m) log
// (n + m)); marching in buckets is linear in its events, and everything after it is linear in the faces.
// Invariant: a run throws before it begins, or its report says what it could not do. Symbolic offsets decide ties in
// every step, and are taken out of the distances at the end.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "base/parallel_chunks.hpp"
#include "diagram/diagram_windows.hpp"
#include "diagram/envelope/trace_envelope.hpp"
#include "diagram/finish_diagram.hpp"
#include "diagram/given_distances.hpp"
#include "diagram/graph/connected_tracer.hpp"
#include "diagram/growth/gap_tracer.hpp"
#include "diagram/growth/trace_paper.hpp"
#include "diagram/trace_bisectors.hpp"
#include "geodesic/marching/fast_marching.hpp"
#include "geodesic/marching/marched_distances.hpp"
#include "geodesic/symbolic_offset.hpp"
#include "geodesic/windows/propagation/propagate_windows.hpp"
#include "geodesic/windows/window_sources.hpp"
#include "gvd/diagram.hpp"
#include "gvd/diagram_steps.hpp"
#include "gvd/error.hpp"
#include "gvd/text.hpp"
#include "gvd/trace_diagram.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {
namespace {

double least_weight(const std::vector<double>& weights) {
  return weights.empty() ? 0 : *std::ranges::min_element(weights);
}

/// How much is added to the distances of each generator before they are compared: the weights, made non-negative, and
/// the symbolic offsets of marching.
struct AddedLengths {
  std::vector<double> weights = {};  ///< >= 0, the least is 0; empty if there are none
  SymbolicOffset symbolic = {};

  double of(GeneratorId g) const { return symbolic.of(g) + (weights.empty() || !g.valid() ? 0 : weights[g.index()]); }
};

/// Takes the labels and distances of the input's own vertices, and subtracts the added lengths. A vertex that was
/// relabelled keeps the distance from its nearest generator.
void take_vertex_labels(const WorkingMesh& working, const TracedDiagram& traced, const AddedLengths& added,
                        Diagram& diagram) {
  const NearestLabels& nearest = traced.nearest();
  diagram.vertex_label.resize(working.input().vertex_count());
  diagram.vertex_distance.resize(working.input().vertex_count());
  for (const VertexId v : working.input().vertices()) {
    diagram.vertex_label[v] = traced.labels.label[v];
    diagram.vertex_distance[v] = std::max(0.0, nearest.distance[v] - added.of(nearest.label[v]));
  }
}

/// Traces by one of the two tracers that read the tables of the faces.
TracedDiagram trace_tables(const WorkingMesh& working, const GeneratorTable& table, const DiagramOptions& options) {
  NearestLabels labels = compute_nearest_labels(working, table);
  if (options.method.tracer == Tracer::paper) {
    PaperTracer tracer(working, table, options.chosen_front(), options.progress);
    return trace_connected(working, std::move(labels), tracer, options.progress);
  }
  GrowthTracer tracer(working, table, options.chosen_front(), options.progress);
  return trace_connected(working, std::move(labels), tracer, options.progress);
}

/// The result of solver and tracer, for the steps that all methods share.
struct Traced {
  TracedDiagram diagram;
  AddedLengths added;  ///< lengths that the distances of the labels contain
};

Traced trace_marched(const WorkingMesh& working, const FastMarchingResult& marched, const DiagramOptions& options,
                     const ParallelChunks& parallel, DiagramReport& report) {
  report.propagation_events = marched.events;
  report.table_entries = static_cast<std::int64_t>(marched.table.entry_count());
  if (options.method.tracer != Tracer::envelope) {
    return {trace_tables(working, marched.table, options), {.symbolic = marched.offset}};
  }
  const MarchedDistances distances(working.mesh(), marched.table);
  EnvelopeTracer tracer(working, distances, chord_length(working.mesh(), options), parallel);
  NearestLabels labels = compute_nearest_labels(working, marched.table);
  return {trace_connected(working, std::move(labels), tracer, options.progress), {.symbolic = marched.offset}};
}

/// The first generator to whose own vertex another generator is nearer, by their weights.
std::optional<HiddenGenerator> find_hidden(const WorkingMesh& working, const WindowField& field) {
  for (const GeneratorId g : working.generator_vertices().ids()) {
    const GeneratorId owner = field.label[working.vertex(g)];
    if (owner != g) return HiddenGenerator{g, owner};
  }
  return std::nullopt;
}

WindowField propagate(const WorkingMesh& working, const DiagramOptions& options, KeepWindows keep) {
  PropagationOptions propagation;
  propagation.keep = keep;
  propagation.departures = keep == KeepWindows::all;
  propagation.offsets = from_zero(options.weights);
  propagation.threads = options.threads;
  return propagate_windows(working, propagation, options.progress);
}

Traced trace_windows(const WorkingMesh& working, const WindowField& field, const DiagramOptions& options,
                     const ParallelChunks& parallel, DiagramReport& report) {
  const Mesh& mesh = working.mesh();
  report.propagation_events = field.carried;
  if (options.method.tracer != Tracer::envelope) {
    const GeneratorTable table = make_generator_table(mesh, field, options.progress);
    report.table_entries = static_cast<std::int64_t>(table.entry_count());
    return {trace_tables(working, table, options), {}};
  }
  const WindowDistances distances(mesh, field);
  EnvelopeTracer tracer(working, distances, chord_length(mesh, options), parallel);
  NearestLabels labels = take_labels(working, field.distance, field.label, parallel);
  return {trace_connected(working, std::move(labels), tracer, options.progress), {from_zero(options.weights)}};
}

/// The number of faces in each class: n1, n2 and n3 of section 4.4 of the paper.
FaceClassCounts count_face_classes(const Mesh& mesh, const IdVector<VertexId, GeneratorId>& label) {
  FaceClassCounts counts;
  for (const FaceId f : mesh.faces()) {
    const FaceClass found = classify(mesh, label, f);
    counts.trivial += found == FaceClass::trivial;
    counts.ordinary += found == FaceClass::ordinary;
    counts.branching += found == FaceClass::branching;
  }
  return counts;
}

void take_counts(const TracedDiagram& traced, DiagramReport& report) {
  const TracerCounts& counts = traced.counts;
  report.relabelled_vertices = counts.relabelled_vertices;
  report.gaps = counts.gaps;
  report.gaps_grown = counts.gaps_grown;
  report.gaps_assembled = counts.gaps - counts.gaps_grown;
  report.straightened_faces = std::ssize(traced.straightened);
  for (const StraightenedFace& f : traced.straightened) {
    report.straightened_error = std::max(report.straightened_error, f.error);
  }
}

/// The steps that all methods share.
void finish(const WorkingMesh& working, const TracedDiagram& traced, const AddedLengths& added,
            const ParallelChunks& parallel, Diagram& diagram, KnownPieces* known = nullptr) {
  take_counts(traced, diagram.report);
  report_progress(parallel.progress(), steps::kCells, 0);
  take_vertex_labels(working, traced, added, diagram);
  diagram.report.face_classes = count_face_classes(working.input(), diagram.vertex_label);
  trace_bisectors(working, traced, parallel, diagram);
  for (BranchPoint& branch : diagram.branch_points) branch.distance += least_weight(diagram.weights);
  collect_cells(working, traced, parallel, diagram, known);
}

/// Runs all steps with the tables that `solve()` makes.
template <class Solve>
Diagram compute_by_tables(const WorkingMesh& working, const std::vector<SurfacePoint>& generators,
                          const DiagramOptions& options, const Solve& solve) {
  const ParallelChunks parallel(options.threads, options.progress);
  Diagram diagram;
  diagram.generators = generators;
  const FastMarchingResult solved = solve();
  const Traced traced = trace_marched(working, solved, options, parallel, diagram.report);
  finish(working, traced.diagram, traced.added, parallel, diagram);
  return diagram;
}

/// Runs all steps of the exact solver after the working mesh. Stops after the windows if a generator has no cell, and
/// returns that generator.
std::optional<HiddenGenerator> trace_and_read(const WorkingMesh& working, const DiagramOptions& options,
                                              KeepWindows keep, const WindowReader& read, Diagram& diagram) {
  const ParallelChunks parallel(options.threads, options.progress);
  const WindowField field = propagate(working, options, keep);
  if (!options.weights.empty()) {
    if (const auto hidden = find_hidden(working, field)) return hidden;
  }
  const Traced traced = trace_windows(working, field, options, parallel, diagram.report);
  finish(working, traced.diagram, traced.added, parallel, diagram);
  if (read) read(working, field, diagram);
  return std::nullopt;
}

std::variant<Diagram, HiddenGenerator> compute_by_windows(const WorkingMesh& working,
                                                          const std::vector<SurfacePoint>& generators,
                                                          const DiagramOptions& options, KeepWindows keep,
                                                          const WindowReader& read) {
  Diagram diagram;
  diagram.generators = generators;
  diagram.weights = options.weights;
  if (const auto hidden = trace_and_read(working, options, keep, read, diagram)) return *hidden;
  return diagram;
}

Diagram diagram_or_throw(std::variant<Diagram, HiddenGenerator>&& computed) {
  if (const auto* const hidden = std::get_if<HiddenGenerator>(&computed)) throw hidden->error();
  return std::get<Diagram>(std::move(computed));
}

}  // namespace

std::vector<double> from_zero(std::vector<double> weights) {
  const double least = least_weight(weights);
  for (double& weight : weights) weight -= least;
  return weights;
}

void finish_diagram(const WorkingMesh& working, const TracedDiagram& traced, const ParallelChunks& parallel,
                    Diagram& diagram, KnownPieces* known) {
  finish(working, traced, {}, parallel, diagram, known);
}

double chord_length(const Mesh& mesh, const DiagramOptions& options) {
  return options.chord_tolerance * mesh.mean_edge_length();
}

void check_diagram_options(const DiagramOptions& options) {
  if (!(options.chord_tolerance >= kLeastChordTolerance) || !std::isfinite(options.chord_tolerance)) {
    throw Error(ErrorCode::invalid_option, "the chord tolerance must be finite and at least 1e-10 mean edge lengths");
  }
  if (options.threads < 0) throw Error(ErrorCode::invalid_option, "the number of threads must not be negative");
  if (!options.weights.empty() && options.method != Method::exact) {
    throw Error(ErrorCode::invalid_option, "weights need the exact method; choose it, or leave them out");
  }
}

void check_weights(const std::vector<double>& weights, std::size_t generators) {
  if (weights.empty()) return;
  if (weights.size() != generators) {
    throw Error(ErrorCode::invalid_option,
                fmt::format("there are {} weights for {} generators; give one for each", weights.size(), generators));
  }
  const auto bad = std::ranges::find_if(weights, [](double w) { return !std::isfinite(w); });
  if (bad == weights.end()) return;
  throw Error(ErrorCode::invalid_option,
              fmt::format("weight {} is {}; give a finite number", bad - weights.begin(), *bad), bad - weights.begin());
}

OrError<Diagram> try_to_compute_diagram(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                                        const DiagramOptions& options) {
  check_diagram_options(options);
  check_weights(options.weights, generators.size());
  auto built = WorkingMesh::try_to_build(mesh, generators, options.progress);
  if (Error* const error = std::get_if<Error>(&built)) return std::move(*error);
  const auto& working = std::get<WorkingMesh>(built);
  if (options.method.solver == Solver::windows) {
    return diagram_or_throw(compute_by_windows(working, generators, options, KeepWindows::near_bisectors, nullptr));
  }
  return compute_by_tables(working, generators, options, [&] {
    const auto march_by_method = options.method == Method::paper ? march_in_order : march;
    return march_by_method(working, options.chosen_front(), options.progress);
  });
}

Diagram compute_diagram(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const DiagramOptions& options) {
  return value_or_throw(try_to_compute_diagram(mesh, generators, options));
}

Diagram trace_diagram(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const DistanceSolver& solver,
                      const DiagramOptions& options) {
  check_diagram_options(options);
  const WorkingMesh working(mesh, generators, options.progress);
  return compute_by_tables(working, generators, options,
                           [&] { return tabulate_distances(working, generators, solver, options.progress); });
}

Diagram trace_diagram(const Mesh& mesh, const std::vector<SurfacePoint>& generators, std::span<const double> distances,
                      const DiagramOptions& options) {
  const auto vertices = static_cast<std::size_t>(mesh.vertex_count());
  if (distances.size() != generators.size() * vertices) {
    throw Error(ErrorCode::invalid_option,
                fmt::format("there are {} distances; {} and {} need {}", distances.size(),
                            counted(std::ssize(generators), "generator", "generators"),
                            counted(mesh.vertex_count(), "vertex", "vertices"), generators.size() * vertices));
  }
  const auto copy_row = [&](GeneratorId g, std::span<double> row) {
    std::ranges::copy(distances.subspan(g.index() * vertices, vertices), row.begin());
  };
  return trace_diagram(mesh, generators, copy_row, options);
}

Diagram compute_diagram_and_read(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                                 const DiagramOptions& options, KeepWindows keep, const WindowReader& read) {
  return diagram_or_throw(try_to_compute_and_read(mesh, generators, options, keep, read));
}

Error HiddenGenerator::error() const {
  return Error(
      ErrorCode::precondition,
      fmt::format("generator {} has no cell, because with these weights generator {} is nearer even at its place; "
                  "weights of two generators must differ by less than their distance",
                  generator.value(), nearer.value()),
      generator.value());
}

std::variant<Diagram, HiddenGenerator> try_to_compute_and_read(const Mesh& mesh,
                                                               const std::vector<SurfacePoint>& generators,
                                                               const DiagramOptions& options, KeepWindows keep,
                                                               const WindowReader& read) {
  check_diagram_options(options);
  check_weights(options.weights, generators.size());
  return compute_by_windows(WorkingMesh(mesh, generators, options.progress), generators, options, keep, read);
}

Diagram compute_diagram(const Mesh& mesh, const std::vector<GeneratorCurve>& curves, const DiagramOptions& options) {
  check_diagram_options(options);
  if (options.method != Method::exact)
    throw Error(ErrorCode::invalid_option, "curves need the exact method; choose it, or give points");
  if (!options.weights.empty())
    throw Error(ErrorCode::invalid_option, "diagrams of curves take no weights; leave them out");
  Diagram diagram;
  const WorkingMesh working(mesh, curves, options.progress);
  diagram.curves = curves;
  for (const GeneratorCurve& curve : curves) diagram.generators.push_back(curve.points.front());
  trace_and_read(working, options, KeepWindows::near_bisectors, nullptr, diagram);
  return diagram;
}

}  // namespace gvd
