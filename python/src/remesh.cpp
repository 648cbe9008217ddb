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
#include "gvd/io/write_file.hpp"
#include "gvd/named_options.hpp"
#include "gvd/remesh_map.hpp"
#include "gvd/remesh_scenes.hpp"

namespace gvd::python {
namespace {

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
  BalanceOptions balancing = make_balance_options(Given(options), input->mesh, compute.make());
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
  return py::make_tuple(MeshDiagram{input, std::move(diagram)}, take(std::move(found.masses)),
                        take(std::move(found.targets)), tied, found.converged);
}

struct Remeshed {
  SharedMesh input;
  std::shared_ptr<const SurfaceRemesh> made;
  int threads = 0;

  const RemeshResult& result() const { return made->result; }
};

Remeshed make_remesh(const SharedMesh& input, const py::dict& given, const ComputeOptions& compute,
                     std::optional<double> error, const py::object& progress) {
  SurfaceRemeshOptions options = make_remesh_options(Given(given), input->mesh, compute.make());
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
             return MeshDiagram{r.input, std::shared_ptr<const Diagram>(r.result, &r.result->diagram)};
           })
      .def("energies", [](const Relaxed& r) { return take(list_energies(*r.result)); })
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
        run_unlocked(py::none(), [&](const Progress&) {
          const std::string format = path.extension().string();
          write_file(path, [&](std::ostream& out) { write_samples(out, r.input->mesh, *r.result, format); });
        });
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
             return MeshDiagram{r.input, std::shared_ptr<const Diagram>(r.made, &r.made->result.diagram)};
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
