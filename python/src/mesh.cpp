// Meshes from arrays and files, and points on them.
//
// Arrays pass the same checks as files: they become a polygon soup, which build_mesh examines. Points become entries of
// a generator list, which resolve_generators turns into surface points: so Python and the commands read the same.
#include "gvd/mesh.hpp"

#include <algorithm>
#include <limits>
#include <span>
#include <tuple>

#include "arrays.hpp"
#include "bindings.hpp"
#include "calls.hpp"
#include "gvd/generator_list.hpp"
#include "gvd/mesh_property.hpp"
#include "gvd/names.hpp"
#include "gvd/read_soup.hpp"
#include "gvd/read_values.hpp"
#include "gvd/sampling.hpp"

namespace gvd::python {
namespace {

SharedMesh mesh_from_arrays(const Array<double>& positions, const Array<std::int64_t>& faces,
                            const std::string& on_defect) {
  const DefectPolicy policy = choose("on_defect", on_defect, kDefectPolicyNames);
  const std::span at(positions.data(), std::size_t(positions.size()));
  const PolygonSoup soup = make_soup(at, {faces.data(), std::size_t(faces.size())}, std::size_t(faces.shape(1)));
  return run_unlocked(py::none(),
                      [&](const Progress&) { return std::make_shared<CheckedMesh>(build_mesh(soup, policy)); });
}

SharedMesh mesh_from_file(const std::filesystem::path& path, const std::optional<std::string>& format,
                          const std::string& on_defect, const std::optional<double>& weld) {
  const DefectPolicy policy = choose("on_defect", on_defect, kDefectPolicyNames);
  std::optional<MeshFormat> known;
  if (format) known = choose("input_format", *format, input_format_names());
  return run_unlocked(py::none(), [&](const Progress&) {
    PolygonSoup soup = read_soup(path, known);
    if (weld) weld_soup(soup, *weld);
    return std::make_shared<CheckedMesh>(build_mesh(soup, policy, path.string()));
  });
}

/// For pickle: the arrays of a mesh, those of its input's elements, the notes, and the appearance.
py::tuple get_state(const py::object& self) {
  const CheckedMesh& c = self.cast<const CheckedMesh&>();
  return py::make_tuple(view(c.mesh.positions(), self), view(c.mesh.face_vertices(), self), view(c.mesh_vertex, self),
                        view(c.input_vertex, self), view(c.input_polygon, self), c.defects.messages,
                        view(c.appearance.texture, self), view(c.appearance.material, self), c.appearance.materials,
                        c.appearance.material_files);
}

SharedMesh set_state(const py::tuple& state) {
  auto checked = std::make_shared<CheckedMesh>();
  checked->mesh = Mesh(to_vector<Vec3>(state[0]), to_vector<std::array<VertexId, 3>>(state[1]));
  checked->mesh_vertex = to_vector<VertexId>(state[2]);
  checked->input_vertex = IdVector<VertexId, std::int32_t>(to_vector<std::int32_t>(state[3]));
  checked->input_polygon = IdVector<FaceId, std::int32_t>(to_vector<std::int32_t>(state[4]));
  using Texts = std::vector<std::string>;
  checked->defects.messages = state[5].cast<Texts>();
  checked->appearance = {
      to_vector<Uv>(state[6]), to_vector<std::int32_t>(state[7]), state[8].cast<Texts>(), state[9].cast<Texts>(), {}};
  return checked;
}

py::dict summarize(const CheckedMesh& checked) {
  const MeshSummary s = compute_mesh_summary(checked.mesh);
  return py::dict(py::arg("vertices") = s.vertices, py::arg("edges") = s.edges, py::arg("faces") = s.faces,
                  py::arg("components") = s.components, py::arg("boundary_loops") = s.boundary_loops,
                  py::arg("euler_characteristic") = s.euler_characteristic, py::arg("area") = s.area,
                  py::arg("bbox_diagonal") = s.bbox_diagonal);
}

PointList resolve(const CheckedMesh& checked, const std::string& name, const Entries& entries,
                  std::optional<double> max_snap, const std::string& coincident) {
  const GeneratorList list = make_list(name, entries);
  return run_unlocked(py::none(), [&](const Progress& progress) {
    return PointList{resolve_points(checked.mesh, list, max_snap, coincident, progress)};
  });
}

PointList sample(const CheckedMesh& checked, const Sampler& sampler, const py::object& progress) {
  SamplingOptions options = sampler.options;
  return run_unlocked(progress, [&](const Progress& reported) {
    options.progress = reported;
    return PointList{sample_generators(checked.mesh, options)};
  });
}

py::array compute_positions(const CheckedMesh& checked, const PointList& list) {
  std::vector<Vec3> positions;
  positions.reserve(list.points.size());
  for (const SurfacePoint& point : list.points) positions.push_back(position(checked.mesh, point));
  return take(std::move(positions));
}

/// With the texture coordinates and materials that the mesh was read with.
void write(const CheckedMesh& checked, const std::filesystem::path& path, const WriteOptions& options) {
  LabelledMesh mesh{checked.mesh};
  mesh.appearance = &checked.appearance;
  run_unlocked(py::none(), [&](const Progress&) { write_result(path, mesh, {}, options); });
}

}  // namespace

GeneratorList make_list(const std::string& name, const Entries& entries) {
  GeneratorList list{name, {}};
  const auto& [kinds, ids, values] = entries;
  const auto at = values.unchecked<2>();
  for (py::ssize_t i = 0; i < kinds.size(); ++i) {
    list.entries.push_back({kPointKinds.at(kinds.at(i)), ids.at(i), {at(i, 0), at(i, 1), at(i, 2)}, 0});
  }
  return list;
}

Sampler::Sampler(const std::string& sampling, std::int64_t count, std::uint64_t seed, std::optional<double> radius,
                 const ComputeOptions& compute) {
  options.kind = radius ? Sampling::covering_radius : choose("sampling", sampling, kSamplingNames);
  options.count = std::int32_t(std::clamp<std::int64_t>(count, -1, std::numeric_limits<std::int32_t>::max()));
  options.seed = seed;
  options.radius = radius.value_or(0);
  options.front = compute.make().chosen_front();
}

void bind_mesh(py::module_& module) {
  py::class_<Sampler>(module, "Sampler")
      .def(py::init<const std::string&, std::int64_t, std::uint64_t, std::optional<double>, const ComputeOptions&>());
  py::class_<PointList>(module, "PointList")
      .def("__len__", [](const PointList& list) { return list.points.size(); })
      .def("part",
           [](const PointList& list, std::size_t begin, std::size_t end) {
             return PointList{{list.points.begin() + begin, list.points.begin() + end}};
           })
      .def("arrays", [](const py::object& self) { return view_points(self.cast<const PointList&>().points, self); });

  py::class_<CheckedMesh, SharedMesh>(module, "Mesh")
      .def_static("from_arrays", &mesh_from_arrays)
      .def_static("from_file", &mesh_from_file)
      .def(py::pickle(&get_state, &set_state))
      .def("vertices",
           [](const py::object& self) { return view(self.cast<const CheckedMesh&>().mesh.positions(), self); })
      .def("faces",
           [](const py::object& self) { return view(self.cast<const CheckedMesh&>().mesh.face_vertices(), self); })
      .def("input_vertex",
           [](const py::object& self) { return view(self.cast<const CheckedMesh&>().input_vertex, self); })
      .def("input_face",
           [](const py::object& self) { return view(self.cast<const CheckedMesh&>().input_polygon, self); })
      .def("texture_coordinates",
           [](const py::object& self) { return view(self.cast<const CheckedMesh&>().appearance.texture, self); })
      .def("notes",
           [](const CheckedMesh& checked) {
             std::vector<std::string> notes;
             for (const std::string& message : checked.defects.messages) {
               notes.push_back(spell_options(message, {spell_argument}));
             }
             return notes;
           })
      .def("summary", &summarize)
      .def("resolve", &resolve)
      .def("sample", &sample)
      .def("count_for", [](const CheckedMesh& checked, double edge) { return count_for_edge(checked.mesh, edge); })
      .def("positions", &compute_positions)
      .def("write", &write)
      .def("page", [](const CheckedMesh& checked, const std::string& title) {
        return run_unlocked(py::none(), [&](const Progress&) { return make_page(LabelledMesh{checked.mesh}, title); });
      });

  module.def("read_values", [](const std::filesystem::path& path) {
    const std::vector<double> values = run_unlocked(py::none(), [&](const Progress&) { return read_values(path); });
    return py::array_t<double>(py::ssize_t(values.size()), values.data());
  });
  module.def("read_properties", [](const std::filesystem::path& path) {
    const auto properties = run_unlocked(py::none(), [&](const Progress&) { return read_mesh_properties(path); });
    py::list found;
    for (const MeshProperty& property : properties) {
      if (property.count_type) continue;  // a list for each element
      const std::vector<double>& values = property.values;
      found.append(py::make_tuple(property.of_vertices ? "vertex" : "face", property.name,
                                  py::array_t<double>(py::ssize_t(values.size()), values.data())));
    }
    return found;
  });
}

}  // namespace gvd::python
