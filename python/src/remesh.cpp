// Relaxations and remeshes, as gvd-lloyd and gvd-remesh make them.
//
// The options come as a dictionary with the commands' names, of those that were given. The library has the way from
// options to results; here are the names, and what the results hold.
#include "gvd/remesh.hpp"

#include <limits>
#include <sstream>

#include "arrays.hpp"
#include "bindings.hpp"
#include "calls.hpp"
#include "gvd/balance.hpp"
#include "gvd/io/point_writer.hpp"
#include "gvd/io/write_file.hpp"
#include "gvd/relaxation_start.hpp"
#include "gvd/remesh_map.hpp"
#include "gvd/remesh_scenes.hpp"
#include "gvd/remesh_surface.hpp"

namespace gvd::python {
namespace {

/// Options by their names. Those that are missing or None keep their defaults.
class Given {
 public:
  explicit Given(const py::dict& options) : options_(options) {}

  bool has(const char* name) const { return options_.contains(name) && !options_[name].is_none(); }
  py::object operator[](const char* name) const { return options_[name]; }

  /// Throws Error{invalid_option} where the value has another type, or is out of its range.
  template <class T>
  void read(const char* name, T& value) const {
    if (!has(name)) return;
    try {
      value = options_[name].cast<T>();
    } catch (const py::cast_error&) {
      const std::string text = py::repr(options_[name]);
      throw Error(ErrorCode::invalid_option, fmt::format("{}: {} is of a wrong kind, or too large", name, text));
    }
  }

  /// Throws Error{invalid_option} for a name that is none of the choices.
  template <class T, class Choice>
  void read(const char* name, T& value, const Choices<Choice>& choices) const {
    if (has(name)) value = choose(name, options_[name].cast<std::string>(), choices);
  }

 private:
  const py::dict& options_;
};

/// A number for each vertex, or else for each face, above 0.
Density make_density(const Mesh& mesh, const Array<double>& values) {
  const std::vector<double> copy(values.data(), values.data() + values.size());
  return values.size() == mesh.vertex_count() ? make_vertex_density(mesh, copy) : make_face_density(mesh, copy);
}

/// Fills in what both commands take: generators, constraints, weight and copy.
void read_start(const Given& given, const Mesh& mesh, RelaxationStartOptions& start) {
  if (given.has("generators")) start.listed = given["generators"].cast<const PointList&>().points;
  if (given.has("sampler")) start.sampling = given["sampler"].cast<const Sampler&>().options;
  if (given.has("fixed")) start.constraints.fixed = given["fixed"].cast<const PointList&>().points;
  given.read("keep_boundary", start.constraints.keep_boundary);
  if (given.has("features")) {
    const bool is_name = py::isinstance<py::str>(given["features"]);
    start.constraints.crease_angle.reset();
    start.constraints.prefers_creases = is_name && choose("features", given["features"].cast<std::string>(),
                                                          Choices<bool>{{"auto", true}, {"none", false}});
    if (start.constraints.prefers_creases) start.constraints.crease_angle = kUsualCreaseAngle;
    if (!is_name) given.read("features", start.constraints.crease_angle);
  }
  given.read("weighs_curvature", start.weighs_curvature);
  if (given.has("density")) start.density = make_density(mesh, given["density"].cast<Array<double>>());
  given.read("gradation", start.gradation);
  given.read("coarse", start.copy.faces);
}

LloydOptions make_lloyd_options(const Given& given) {
  LloydOptions options;
  given.read("accelerate", options.acceleration, kAccelerationNames);
  given.read("relocate", options.relocate);
  given.read("iterations", options.max_iterations);
  given.read("tolerance", options.energy_tolerance);
  given.read("move_tolerance", options.move_tolerance);
  given.read("step", options.step);
  return options;
}

struct Relaxed {
  SharedMesh input;
  std::shared_ptr<const LloydResult> result;
};

Relaxed relax(const SharedMesh& input, const py::dict& options, const ComputeOptions& compute,
              const py::object& progress) {
  const Given given(options);
  LloydOptions relaxation = make_lloyd_options(given);
  relaxation.diagram = compute.make();
  RelaxationStartOptions start;
  read_start(given, input->mesh, start);
  start.threads = compute.threads;
  start.copy = copy_options(relaxation, start.copy);
  return run_unlocked(progress, [&](const Progress& reported) {
    start.progress = relaxation.progress = reported;
    const RelaxationStart made = start_relaxation(input->mesh, start);
    return Relaxed{input, std::make_shared<const LloydResult>(relax_generators(input->mesh, made, relaxation))};
  });
}

/// A balanced diagram, its masses and targets, the sets of tied cells, and whether the search converged.
py::tuple balance(const SharedMesh& input, const PointList& generators, const py::dict& options,
                  const ComputeOptions& compute, const py::object& progress) {
  const Given given(options);
  BalanceOptions balancing;
  balancing.diagram = compute.make();
  given.read("shares", balancing.shares);
  given.read("weights", balancing.diagram.weights);
  if (given.has("density")) balancing.density = make_density(input->mesh, given["density"].cast<Array<double>>());
  BalancedDiagram found = run_unlocked(progress, [&](const Progress& reported) {
    balancing.diagram.progress = reported;
    return balance_cells(input->mesh, generators.points, balancing);
  });
  py::list tied;
  for (const auto& set : found.tied) {
    py::list cells;
    for (const GeneratorId g : set) cells.append(g.value());
    tied.append(py::tuple(cells));
  }
  auto diagram = std::make_shared<const Diagram>(std::move(found.diagram));
  return py::make_tuple(std::make_shared<MeshDiagram>(MeshDiagram{input, std::move(diagram)}),
                        take(std::move(found.masses)), take(std::move(found.targets)), tied, found.converged);
}

std::vector<double> energies(const Relaxed& relaxed) {
  std::vector<double> found{relaxed.result->initial_energy};
  for (const LloydIteration& iteration : relaxed.result->iterations) found.push_back(iteration.energy);
  return found;
}

/// The file of gvd-lloyd --points.
void write_samples(const Relaxed& relaxed, const std::filesystem::path& path) {
  const auto format = parse_point_format(path.extension().string());
  if (!format) throw Error(ErrorCode::invalid_option, path.string() + ": points are written as .ply, .xyz or .npy");
  std::vector<SurfaceSample> samples;
  for (const GeneratorId g : relaxed.result->moments.ids()) {
    const CellMoments& moments = relaxed.result->moments[g];
    samples.push_back({relaxed.result->generators[g.index()], moments.area, moments.energy});
  }
  write_file(path, [&](std::ostream& out) { write_points(out, relaxed.input->mesh, samples, *format); });
}

struct Remeshed {
  SharedMesh input;
  std::shared_ptr<const SurfaceRemesh> made;
  int threads = 0;

  const RemeshResult& result() const { return made->result; }
};

SurfaceRemeshOptions make_remesh_options(const Given& given, const Mesh& mesh, const ComputeOptions& compute) {
  SurfaceRemeshOptions options;
  read_start(given, mesh, options.start);
  options.start.threads = compute.threads;
  given.read("prefers_boundary", options.start.constraints.prefers_boundary);
  given.read("relax", options.relaxation);
  given.read("place", options.placement, kPlacementNames);
  given.read("shape", options.remesh.placement.shape);
  given.read("exact_count", options.exact_count);
  given.read("max_added", options.remesh.max_added);
  given.read("refine", options.remesh.refine);
  given.read("allow_intersections", options.remesh.allow_intersections);
  options.remesh.diagram = compute.make();
  return options;
}

Remeshed make_remesh(const SharedMesh& input, const py::dict& given, const ComputeOptions& compute,
                     std::optional<double> error, const py::object& progress) {
  SurfaceRemeshOptions options = make_remesh_options(Given(given), input->mesh, compute);
  return run_unlocked(progress, [&](const Progress& reported) {
    options.start.progress = options.remesh.diagram.progress = reported;
    if (error) options.start.sampling.count = *find_remesh_count(input->mesh, options, *error).count;
    return Remeshed{input, std::make_shared<const SurfaceRemesh>(remesh_surface(input->mesh, options)),
                    compute.threads};
  });
}

std::string make_remesh_page(const Remeshed& made, const std::string& title) {
  ViewOptions options;
  options.title = title;
  const Mesh unplaced = make_unplaced(made.input->mesh, made.result());
  return make_view_page(make_remesh_scenes(made.input->mesh, made.result(), unplaced, made.threads), options);
}

void write_remesh(const Remeshed& made, const std::filesystem::path& path, const WriteOptions& options) {
  const OwnFormats own{{"json", [&](std::ostream& out) { write_remesh_json(out, made.input->mesh, made.result()); }},
                       {"html", [&](std::ostream& out) { out << make_remesh_page(made, options.title); }}};
  write_result(path, LabelledMesh{made.result().mesh}, own, options);
}

py::dict describe(const Remeshed& made) {
  const RemeshResult& result = made.result();
  const auto distance = [](const SurfaceDistance& d) {
    return py::dict(py::arg("hausdorff") = d.hausdorff, py::arg("rms") = d.rms);
  };
  return py::dict(py::arg("added") = result.added, py::arg("left_out") = result.left_out,
                  py::arg("input_to_output") = distance(result.input_to_output),
                  py::arg("output_to_input") = distance(result.output_to_input),
                  py::arg("q_average") = result.output_quality.q_average,
                  py::arg("angle_min") = result.output_quality.angle_min);
}

struct Map {
  SharedMesh input;
  RemeshMap map;
};

void bind_relaxation(py::module_& module) {
  py::class_<Relaxed>(module, "Relaxation")
      .def("diagram",
           [](const Relaxed& r) {
             return std::make_shared<MeshDiagram>(
                 MeshDiagram{r.input, std::shared_ptr<const Diagram>(r.result, &r.result->diagram)});
           })
      .def("energies", [](const Relaxed& r) { return take(energies(r)); })
      .def("areas",
           [](const py::object& self) {
             return view(self.cast<const Relaxed&>().result->moments.raw(), &CellMoments::area, self);
           })
      .def("cell_energies",
           [](const py::object& self) {
             return view(self.cast<const Relaxed&>().result->moments.raw(), &CellMoments::energy, self);
           })
      .def("stop", [](const Relaxed& r) { return name_in(kLloydStopNames, r.result->stop); })
      .def("residual", [](const Relaxed& r) { return r.result->residual; })
      .def("write_samples", [](const Relaxed& r, const std::filesystem::path& path) {
        run_unlocked(py::none(), [&](const Progress&) { write_samples(r, path); });
      });
  module.def("balance", &balance);
  module.def("relax", &relax);
}

void bind_map(py::module_& module) {
  py::class_<Map>(module, "RemeshMap")
      .def("points", [](const py::object& self) { return view_points(self.cast<const Map&>().map.points.raw(), self); })
      .def("origins",
           [](const py::object& self) { return view_points(self.cast<const Map&>().map.origins.raw(), self); })
      .def("one_to_one", [](const Map& m) { return m.map.one_to_one; })
      .def("write", [](const Map& m, const std::filesystem::path& path) {
        run_unlocked(py::none(), [&](const Progress&) {
          write_file(path, [&](std::ostream& out) { write_map_json(out, *m.input, m.map); });
        });
      });
}

}  // namespace

void bind_remesh(py::module_& module) {
  bind_relaxation(module);
  bind_map(module);
  py::class_<Remeshed>(module, "Remesh")
      .def("mesh", [](const Remeshed& r) { return std::make_shared<CheckedMesh>(as_input(r.result().mesh)); })
      .def("diagram",
           [](const Remeshed& r) {
             return std::make_shared<MeshDiagram>(
                 MeshDiagram{r.input, std::shared_ptr<const Diagram>(r.made, &r.made->result.diagram)});
           })
      .def("describe", &describe)
      .def("map",
           [](const Remeshed& r, const py::object& progress) {
             return run_unlocked(progress, [&](const Progress& reported) {
               return Map{r.input, map_to_remesh(r.input->mesh, r.result(), r.threads, reported)};
             });
           })
      .def("write",
           [](const Remeshed& r, const std::filesystem::path& path, const WriteOptions& options) {
             run_unlocked(py::none(), [&](const Progress&) { write_remesh(r, path, options); });
           })
      .def("page", [](const Remeshed& r, const std::string& title) {
        return run_unlocked(py::none(), [&](const Progress&) { return make_remesh_page(r, title); });
      });
  module.def("remesh", &make_remesh);
}

}  // namespace gvd::python
