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

/// Refuses an empty list: there would be no generator.
CurveSet refuse_none(std::vector<GeneratorCurve> curves, const char* reason) {
  if (curves.empty()) throw Error(ErrorCode::precondition, fmt::format("curves: {}", reason));
  return {std::move(curves)};
}

CurveSet find_boundary(const CheckedMesh& of) { return refuse_none(boundary_curves(of.mesh), "the mesh is closed"); }

/// Edges whose faces differ by more than `angle`, degrees; by default as --curves creases.
CurveSet find_creases(const CheckedMesh& of, std::optional<double> angle) {
  const double least = angle.value_or(kUsualCreaseAngle);
  if (!(least > 0 && least < 180)) throw Error(ErrorCode::invalid_option, "angle: it is not above 0 and below 180");
  return refuse_none(crease_curves(of.mesh, least * std::numbers::pi / 180), "no two faces meet at such an angle");
}

/// How far points were moved is known to `max_snap` only: no note is written.
CurveSet make_curves(const CheckedMesh& of, const CurveList& list, ResolveOptions options) {
  return run_unlocked(py::none(), [&](const Progress& progress) {
    options.progress = progress;
    ResolvedGenerators snapped;
    return CurveSet{resolve_curves(of.mesh, list, options, snapped)};
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
  CurveList list;
  list.points.name = "curves";
  for (const Entries& entries : polylines) {
    const auto first = std::int32_t(list.points.entries.size());
    append_entries(list.points, entries);
    const auto end = std::int32_t(list.points.entries.size());
    list.curve.resize(std::size_t(end), std::int32_t(&entries - polylines.data()));
    for (std::int32_t i = first + 1; i < end; ++i) list.segments.push_back({i - 1, i});
    if (closed && end - first > 2) list.segments.push_back({end - 1, first});
  }
  return make_curves(of, list, {.max_snap = max_snap});
}

/// For each curve its polylines, arrays of positions.
py::list positions_of(const CheckedMesh& of, const CurveSet& set) {
  py::list result;
  for (const GeneratorCurve& curve : set.curves) {
    py::list parts;
    for (std::vector<Vec3>& line : polylines(of.mesh, curve)) parts.append(take(std::move(line)));
    result.append(parts);
  }
  return result;
}

}  // namespace

void bind_curves(py::module_& module) {
  py::class_<CurveSet>(module, "CurveSet")
      .def_static("boundary", &find_boundary)
      .def_static("creases", &find_creases)
      .def_static("read", &read_curve_file)
      .def_static("join", &join_polylines)
      .def("__len__", [](const CurveSet& set) { return set.curves.size(); })
      .def("polylines", [](const CurveSet& set, const CheckedMesh& of) { return positions_of(of, set); });
}

}  // namespace gvd::python
