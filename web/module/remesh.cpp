// Relaxed generators, balanced cells and remeshes, with the options of Python (gvd/named_options.hpp).
#include "gvd/remesh.hpp"

#include <sstream>

#include "gvd/named_options.hpp"
#include "gvd/remesh_map.hpp"
#include "gvd/remesh_scenes.hpp"
#include "scenes.hpp"
#include "values.hpp"

namespace gvd::web {
namespace {

struct Relaxed {
  SharedMesh input;
  std::shared_ptr<const LloydResult> result;
};

struct Remeshed {
  SharedMesh input;
  std::shared_ptr<const SurfaceRemesh> made;

  const RemeshResult& result() const { return made->result; }
};

struct Map {
  SharedMesh input;
  RemeshMap map;
};

Relaxed lloyd(const SharedMesh& input, const val& options) {
  return guarded([&] {
    const Mesh& mesh = input->mesh;
    const Given given(mesh, options);
    LloydOptions relaxation = make_lloyd_options(given);
    relaxation.diagram = given.diagram();
    RelaxationStartOptions start;
    read_start(given, mesh, start);
    start.copy = copy_options(relaxation, start.copy);
    start.progress = relaxation.progress = given.progress();
    if (given.has("on_iteration")) {
      relaxation.on_iteration = [call = given["on_iteration"]](std::int64_t count, double energy, const auto& points) {
        call(double(count), energy, to_points(points));
      };
    }
    const RelaxationStart made = start_relaxation(mesh, start);
    return Relaxed{input, std::make_shared<const LloydResult>(relax_generators(mesh, made, relaxation))};
  });
}

/// One number of every cell's moments.
template <double CellMoments::*member>
val moments(const Relaxed& relaxed) {
  std::vector<double> found;
  for (const CellMoments& cell : relaxed.result->moments) found.push_back(cell.*member);
  return to_array(found);
}

/// {diagram, masses, targets, tied, converged}
val balance(const SharedMesh& input, const val& points, const val& options) {
  return guarded([&] {
    const Given given(input->mesh, options);
    const BalanceOptions balancing = make_balance_options(given, input->mesh, given.diagram());
    BalancedDiagram found = balance_cells(input->mesh, resolve(input->mesh, "points", points), balancing);
    val tied = val::array();
    for (const auto& set : found.tied) tied.call<void>("push", to_array(set));
    return object({{"diagram", val(MeshDiagram{input, std::make_shared<const Diagram>(std::move(found.diagram))})},
                   {"masses", to_array(found.masses)},
                   {"targets", to_array(found.targets)},
                   {"tied", tied},
                   {"converged", val(found.converged)}});
  });
}

Remeshed remesh_of(const SharedMesh& input, const val& options) {
  return guarded([&] {
    const Mesh& mesh = input->mesh;
    const Given given(mesh, options);
    SurfaceRemeshOptions remesh = make_remesh_options(given, mesh, given.diagram());
    remesh.start.progress = given.progress();
    if (given.has("target_edge")) {
      double edge = 0;
      given.read("target_edge", edge);
      remesh.start.sampling.count = count_for_edge(mesh, edge);
    }
    std::optional<double> error;
    given.read("error", error);
    if (error) remesh.start.sampling.count = *find_remesh_count(mesh, remesh, *error).count;
    return Remeshed{input, std::make_shared<const SurfaceRemesh>(remesh_surface(mesh, remesh))};
  });
}

val figures(const Remeshed& made) {
  const RemeshResult& result = made.result();
  const auto distance = [](const SurfaceDistance& d) {
    return object({{"hausdorff", val(d.hausdorff)}, {"rms", val(d.rms)}});
  };
  return object({{"added", val(double(result.added))},
                 {"left_out", val(double(result.left_out))},
                 {"input_to_output", distance(result.input_to_output)},
                 {"output_to_input", distance(result.output_to_input)},
                 {"q_average", val(result.output_quality.q_average)},
                 {"angle_min", val(result.output_quality.angle_min)}});
}

val certificate(const Remeshed& made) {
  const RemeshCertificate& c = made.result().certificate;
  return object({{"ok", val(c.ok())},
                 {"manifold", val(c.manifold)},
                 {"closed_as_input", val(c.closed_as_input)},
                 {"same_euler_characteristic", val(c.same_euler_characteristic)},
                 {"same_components", val(c.same_components)},
                 {"same_boundary_loops", val(c.same_boundary_loops)},
                 {"same_in_each_component", val(c.same_in_each_component)},
                 {"flipped_faces", val(double(c.flipped_faces))},
                 {"self_intersections", val(double(c.self_intersections.size()))},
                 {"inherited_intersections", val(double(c.inherited_intersections))}});
}

Map map_of(const Remeshed& made, const val& options) {
  return guarded([&] {
    const Mesh& mesh = made.input->mesh;
    return Map{made.input, map_to_remesh(mesh, made.result(), 1, Given(mesh, options).progress())};
  });
}

/// The coarse mesh in the coordinates of its input's scenes, with the input over it.
val scene_of(Scenes& scenes, const Remeshed& made) {
  return guarded([&] {
    const Mesh unplaced = make_unplaced(made.input->mesh, made.result());
    return scenes.show(make_remesh_scenes(made.input->mesh, made.result(), unplaced, 1).front());
  });
}

val write_remesh(const Remeshed& made, const std::string& format, const val& options) {
  return guarded([&] {
    const auto json = [&](std::ostream& out) { write_remesh_json(out, made.input->mesh, made.result()); };
    return write_result(LabelledMesh{made.result().mesh}, format, Given(made.input->mesh, options), {{"json", json}});
  });
}

void bind_map() {
  emscripten::class_<Map>("RemeshMap")
      .function(
          "points", +[](const Map& m) { return to_points(m.map.points.raw()); })
      .function(
          "origins", +[](const Map& m) { return to_points(m.map.origins.raw()); })
      .function(
          "one_to_one", +[](const Map& m) { return m.map.one_to_one; })
      .function(
          "write", +[](const Map& m, const std::string&, const val&) {
            std::ostringstream out;
            write_map_json(out, *m.input, m.map);
            return to_bytes(out.str());
          });
}

}  // namespace

void bind_remesh() {
  emscripten::class_<Relaxed>("Relaxation")
      .function(
          "diagram",
          +[](const Relaxed& r) {
            return MeshDiagram{r.input, std::shared_ptr<const Diagram>(r.result, &r.result->diagram)};
          })
      .function(
          "energies", +[](const Relaxed& r) { return to_array(list_energies(*r.result)); })
      .function("areas", &moments<&CellMoments::area>)
      .function("cell_energies", &moments<&CellMoments::energy>)
      .function(
          "stop", +[](const Relaxed& r) { return std::string(name_in(kLloydStopNames, r.result->stop)); })
      .function(
          "residual", +[](const Relaxed& r) { return r.result->residual; })
      .function(
          "write_samples", +[](const Relaxed& r, const std::string& format) {
            return guarded([&] {
              std::ostringstream out;
              write_samples(out, r.input->mesh, *r.result, format);
              return to_bytes(out.str());
            });
          });
  emscripten::class_<Remeshed>("Remesh")
      .function(
          "mesh", +[](const Remeshed& r) { return std::make_shared<CheckedMesh>(as_input(r.result().mesh)); })
      .function(
          "diagram",
          +[](const Remeshed& r) {
            return MeshDiagram{r.input, std::shared_ptr<const Diagram>(r.made, &r.result().diagram)};
          })
      .function("figures", &figures)
      .function("certificate", &certificate)
      .function("map", &map_of)
      .function("write", &write_remesh);
  bind_map();
  emscripten::function("lloyd", &lloyd);
  emscripten::function("balance", &balance);
  emscripten::function("remesh", &remesh_of);
  emscripten::function("remesh_scene", &scene_of);
}

}  // namespace gvd::web
