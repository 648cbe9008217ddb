// Exact distances, shortest paths and logarithms.
//
// Distances to the nearest of several points come from one field, with all threads. Rows, one for each point, come from
// a field for each: one thread makes a whole row, so that all cores are busy and no row depends on their number.
#include <algorithm>
#include <sstream>

#include "arrays.hpp"
#include "bindings.hpp"
#include "calls.hpp"
#include "gvd/exact_field.hpp"
#include "gvd/io/distance_writer.hpp"
#include "gvd/io/write_file.hpp"

namespace gvd::python {
namespace {

/// Of points or curves, the member `of` of a list.
template <class List, auto of>
py::tuple compute_nearest(const SharedMesh& input, const List& from, const PointList* at, int threads,
                          const py::object& progress) {
  VertexDistances found = run_unlocked(progress, [&](const Progress& reported) {
    return measure(input->mesh, from.*of, at != nullptr ? &at->points : nullptr, {{}, reported, threads});
  });
  return py::make_tuple(take(std::move(found.distance)), take(std::move(found.label)));
}

/// The distances of every vertex, or of `at`, from each point: one row for each.
py::array compute_rows(const SharedMesh& input, const PointList& from, const PointList* at, int threads,
                       const py::object& progress) {
  const std::size_t rows = from.points.size();
  const std::size_t columns = at != nullptr ? at->points.size() : std::size_t(input->mesh.vertex_count());
  py::array_t<double> result({rows, columns});
  double* const out = result.mutable_data();
  run_unlocked(progress, [&](const Progress& reported) {
    compute_distance_rows(input->mesh, from.points, at != nullptr ? &at->points : nullptr, {out, rows * columns},
                          {.progress = reported, .threads = threads});
  });
  return result;
}

/// The path from each point to the nearest of `to`: its points, the index of that one, length, and whether complete.
py::list compute_paths(const SharedMesh& input, const PointList& from, const PointList& to, int threads,
                       const py::object& progress) {
  const auto trace_all = [&](const Progress& reported) {
    return trace_paths(input->mesh, from.points, to.points, {{}, reported, threads});
  };
  py::list result;
  for (GeodesicPath& path : run_unlocked(progress, trace_all)) {
    result.append(
        py::make_tuple(PointList{std::move(path.points)}, path.generator.value(), path.length, path.complete));
  }
  return result;
}

/// The table of one path, as gvd-distance --paths writes it.
py::bytes format_path(const Array<std::int32_t>& face, const Array<double>& bary, const Array<double>& positions,
                      double length, std::int32_t end, std::int64_t start_vertex, std::int64_t end_vertex) {
  TargetPath path{0, GeneratorId(end), {{}, {}, length}};
  for (py::ssize_t k = 0; k < face.size(); ++k) {
    path.path.points.push_back({FaceId(face.at(k)), {bary.at(k, 0), bary.at(k, 1), bary.at(k, 2)}});
    path.positions.emplace_back(positions.at(k, 0), positions.at(k, 1), positions.at(k, 2));
  }
  std::vector<std::int64_t> ends(std::size_t(std::max(end, 0)) + 1, -1);
  ends.back() = end_vertex;
  std::ostringstream out;
  write_paths_csv(out,
                  {.source_vertices = std::move(ends), .target_vertices = {start_vertex}, .paths = {std::move(path)}});
  return out.str();
}

/// The logarithm of every vertex at the only point of `at`.
py::array compute_logs(const SharedMesh& input, const PointList& at, int threads, const py::object& progress) {
  return take(run_unlocked(progress, [&](const Progress& reported) {
    return compute_log_map(input->mesh, at.points.at(0), {{}, reported, threads});
  }));
}

}  // namespace

void bind_distances(py::module_& module) {
  module.def("nearest", &compute_nearest<PointList, &PointList::points>);
  module.def("nearest", &compute_nearest<CurveSet, &CurveSet::curves>);
  module.def("rows", &compute_rows);
  module.def("paths", &compute_paths);
  module.def("logs", &compute_logs);
  module.def("format_path", &format_path);
  module.def("write_file", [](const std::filesystem::path& path, const std::string& content) {
    write_file(path, [&](std::ostream& out) { out << content; });
  });
}

}  // namespace gvd::python
