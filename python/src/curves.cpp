// Curves as generators: the boundary loops or the creases of a mesh, those of a file, or polylines through points.
//
// Polylines pass the same steps as files: entries of a list, which resolve_curves turns into curves of the surface. So
// a point is moved to the surface here as it is there, and curves that meet are one.
#include <numbers>

#include "arrays.hpp"
#include "bindings.hpp"
#include "calls.hpp"
#include "gvd/constrained_start.hpp"
#include "gvd/curve_list.hpp"
#include "gvd/error.hpp"

namespace gvd::python {
namespace {

CurveSet find(const CheckedMesh& of, const std::string& kind, std::optional<double> angle) {
  return find_curves(of.mesh, kind, angle);
}

CurveSet make_curves(const CheckedMesh& of, const CurveList& list, ResolveOptions options) {
  return run_unlocked(py::none(), [&](const Progress& progress) {
    options.progress = progress;
    return snap_curves(of.mesh, list, std::move(options));
  });
}

/// Numbers of vertices in a file are those of the mesh's own file.
CurveSet read_curve_file(const CheckedMesh& of, const std::filesystem::path& path, std::optional<double> max_snap) {
  const CurveList list = run_unlocked(py::none(), [&](const Progress&) { return read_curves(path); });
  return make_curves(of, list, {.input_vertices = &of.mesh_vertex, .max_snap = max_snap});
}

/// One polyline for each element of `polylines`.
CurveSet join_polylines(const CheckedMesh& of, const std::vector<Entries>& polylines, bool closed,
                        std::optional<double> max_snap) {
  std::vector<GeneratorList> lists;
  for (const Entries& entries : polylines) lists.push_back(make_list("", entries));
  return make_curves(of, gvd::join_polylines(lists, closed), {.max_snap = max_snap});
}

/// For each curve its polylines, arrays of positions.
py::list positions_of(const CheckedMesh& of, const CurveSet& set) {
  py::list result;
  for (const GeneratorCurve& curve : set.curves) {
    py::list parts;
    for (std::vector<Vec3>& line : gvd::polylines(of.mesh, curve)) parts.append(take(std::move(line)));
    result.append(parts);
  }
  return result;
}

}  // namespace

void bind_curves(py::module_& module) {
  py::class_<CurveSet>(module, "CurveSet")
      .def_static("find", &find)
      .def_static("read", &read_curve_file)
      .def_static("join", &join_polylines)
      .def("__len__", [](const CurveSet& set) { return set.curves.size(); })
      .def("polylines", [](const CurveSet& set, const CheckedMesh& of) { return positions_of(of, set); });
}

}  // namespace gvd::python
