// Curves of a mesh as generators: its boundary or creases, those of a file's bytes, or polylines through points.
#include "gvd/curve_list.hpp"
#include "values.hpp"

namespace gvd::web {
namespace {

CurveSet find(const SharedMesh& input, const std::string& kind, const val& given) {
  return guarded([&] {
    std::optional<double> angle;
    Given(input->mesh, given).read("angle", angle);
    return find_curves(input->mesh, kind, angle);
  });
}

/// Numbers of vertices in a file are those of the mesh's own file.
CurveSet read(const SharedMesh& input, const std::string& bytes, const std::string& name, const val& given) {
  return guarded([&] {
    ResolveOptions options{.input_vertices = &input->mesh_vertex};
    Given(input->mesh, given).read("max_snap", options.max_snap);
    return snap_curves(input->mesh, parse_curves(bytes, name), options);
  });
}

/// One polyline for each element of `polylines`.
CurveSet join(const SharedMesh& input, const val& polylines, bool closed, const val& given) {
  return guarded([&] {
    std::vector<GeneratorList> lists;
    for (const val& entries : emscripten::vecFromJSArray<val>(polylines)) lists.push_back(make_list("curves", entries));
    ResolveOptions options;
    Given(input->mesh, given).read("max_snap", options.max_snap);
    return snap_curves(input->mesh, join_polylines(lists, closed), options);
  });
}

/// For each curve its polylines, arrays of coordinates.
val positions_of(const CurveSet& set, const SharedMesh& input) {
  val result = val::array();
  for (const GeneratorCurve& curve : set.curves) {
    val parts = val::array();
    for (const std::vector<Vec3>& line : polylines(input->mesh, curve)) parts.call<void>("push", to_array(line));
    result.call<void>("push", parts);
  }
  return result;
}

}  // namespace

void bind_curves() {
  emscripten::class_<CurveSet>("CurveSet").function("positions", &positions_of);
  emscripten::function("find_curves", &find);
  emscripten::function("read_curves", &read);
  emscripten::function("join_curves", &join);
}

}  // namespace gvd::web
