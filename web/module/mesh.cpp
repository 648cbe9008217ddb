// Meshes from arrays and bytes, points on them, exact distances, shortest paths and isolines.
#include "gvd/mesh.hpp"

#include <sstream>

#include "gvd/exact_field.hpp"
#include "gvd/io/mesh_writer.hpp"
#include "gvd/read_soup.hpp"
#include "gvd/read_values.hpp"
#include "values.hpp"

namespace gvd::web {
namespace {

DefectPolicy policy_of(const std::string& on_defect) {
  if (const auto policy = value_in(kDefectPolicyNames, on_defect)) return *policy;
  throw Error(ErrorCode::invalid_option,
              fmt::format("on_defect: '{}' is none of {}", on_defect, fmt::join(names_in(kDefectPolicyNames), ", ")));
}

SharedMesh mesh_from_arrays(const val& vertices, const val& faces, std::size_t corners, const std::string& on_defect) {
  return guarded([&] {
    const auto at = emscripten::convertJSArrayToNumberVector<double>(vertices);
    const auto given = emscripten::convertJSArrayToNumberVector<double>(faces);
    const PolygonSoup soup = make_soup(at, std::vector<std::int64_t>(given.begin(), given.end()), corners);
    return std::make_shared<CheckedMesh>(build_mesh(soup, policy_of(on_defect)));
  });
}

/// `name` stands for the file in messages; its extension counts where the content does not tell the format. `weld` is
/// the tolerance of `weld_soup`, or null.
SharedMesh mesh_from_bytes(const std::string& bytes, const std::string& name, const std::string& on_defect,
                           const val& weld) {
  return guarded([&] {
    const auto format = detect_format(bytes, name);
    if (!format) {
      throw Error(
          ErrorCode::unreadable_input,
          name + ": neither the content nor the name's extension is that of OBJ, PLY, OFF, STL, glTF, MNI or VTK");
    }
    const DefectPolicy policy = policy_of(on_defect);
    PolygonSoup soup = parse_soup(bytes, *format, name);
    if (!weld.isNull()) weld_soup(soup, weld.as<double>());
    return std::make_shared<CheckedMesh>(build_mesh(soup, policy, name));
  });
}

val notes(const SharedMesh& input) {
  val list = val::array();
  for (const std::string& line : input->defects.messages) list.call<void>("push", spell_properties(line));
  return list;
}

val summary(const SharedMesh& input) {
  const MeshSummary s = compute_mesh_summary(input->mesh);
  return object({{"vertices", val(double(s.vertices))},
                 {"edges", val(double(s.edges))},
                 {"faces", val(double(s.faces))},
                 {"components", val(double(s.components))},
                 {"boundary_loops", val(double(s.boundary_loops))},
                 {"euler_characteristic", val(double(s.euler_characteristic))},
                 {"area", val(s.area)},
                 {"bbox_diagonal", val(s.bbox_diagonal)}});
}

val sample(const SharedMesh& input, const val& given) {
  return guarded([&] {
    const Given options(input->mesh, given);
    SamplingOptions sampling = options.sampling("");
    sampling.progress = options.progress();
    return to_points(sample_generators(input->mesh, sampling));
  });
}

val nearest(const SharedMesh& input, const val& points, const val& given) {
  return guarded([&] {
    const Given options(input->mesh, given);
    const auto at = options.has("at") ? std::optional(options.points("at")) : std::nullopt;
    const VertexDistances found = with_sources(input->mesh, points, [&](const auto& from) {
      return measure(input->mesh, from, at ? &*at : nullptr, {.progress = options.progress()});
    });
    return object({{"distances", to_array(found.distance)}, {"labels", to_array(found.label)}});
  });
}

/// A row for each point, one after the other: the distances of all vertices, or of `at`.
val rows(const SharedMesh& input, const val& points, const val& given) {
  return guarded([&] {
    const Given options(input->mesh, given);
    const std::vector<SurfacePoint> sources = resolve(input->mesh, "points", points);
    const auto at = options.has("at") ? options.points("at") : std::vector<SurfacePoint>();
    std::vector<double> found(sources.size() * (at.empty() ? input->mesh.positions().size() : at.size()));
    compute_distance_rows(input->mesh, sources, at.empty() ? nullptr : &at, found, {.progress = options.progress()});
    return to_array(found);
  });
}

/// The path from each start to the nearest end.
val paths(const SharedMesh& input, const val& start, const val& end, const val& given) {
  return guarded([&] {
    const Mesh& mesh = input->mesh;
    const auto from = resolve(mesh, "start", start), to = resolve(mesh, "end", end);
    val list = val::array();
    for (const GeodesicPath& path : trace_paths(mesh, from, to, {.progress = Given(mesh, given).progress()})) {
      list.call<void>("push", object({{"points", to_points(path.points)},
                                      {"positions", to_positions(mesh, path.points)},
                                      {"length", val(path.length)},
                                      {"complete", val(path.complete)},
                                      {"end", val(path.generator.value())}}));
    }
    return list;
  });
}

val log_map(const SharedMesh& input, const val& point, const val& given) {
  return guarded([&] {
    const Mesh& mesh = input->mesh;
    const SurfacePoint at = resolve(mesh, "point", point).at(0);
    return to_array(compute_log_map(mesh, at, {.progress = Given(mesh, given).progress()}));
  });
}

val isolines(const SharedMesh& input, const val& points, const val& levels, const val& given) {
  return guarded([&] {
    const Mesh& mesh = input->mesh;
    const ExactField field(mesh, resolve(mesh, "points", points), {.progress = Given(mesh, given).progress()});
    val list = val::array();
    for (const Isoline& line : field.isolines(emscripten::convertJSArrayToNumberVector<double>(levels))) {
      list.call<void>("push", object({{"level", val(line.level)},
                                      {"closed", val(line.closed)},
                                      {"points", to_points(line.points)},
                                      {"positions", to_positions(mesh, line.points)}}));
    }
    return list;
  });
}

val write_mesh_file(const SharedMesh& input, const std::string& format, const val& given) {
  return guarded([&] {
    LabelledMesh mesh{input->mesh};
    mesh.appearance = &input->appearance;
    return write_result(mesh, format, Given(input->mesh, given), {});
  });
}

}  // namespace

val write_result(LabelledMesh mesh, const std::string& format, const Given& options, const OwnFormats& own) {
  options.read("no_curves", mesh.no_bisectors);
  options.read("ascii_ply", mesh.ascii_ply);
  options.read("region_materials", mesh.region_materials);
  std::ostringstream out;
  if (const auto found = std::ranges::find(own, format, &OwnFormats::value_type::first); found != own.end()) {
    found->second(out);
  } else if (const auto known = parse_output_format(format)) {
    write_mesh(out, mesh, *known);
  } else {
    throw Error(ErrorCode::invalid_option, fmt::format("'{}' is no format that is written here", format));
  }
  return to_bytes(out.str());
}

void bind_mesh() {
  emscripten::class_<SharedMesh>("Mesh")
      .function(
          "vertices", +[](const SharedMesh& m) { return to_array(m->mesh.positions()); })
      .function(
          "faces", +[](const SharedMesh& m) { return to_array(m->mesh.face_vertices()); })
      .function(
          "input_vertex", +[](const SharedMesh& m) { return to_array(m->input_vertex); })
      .function(
          "input_face", +[](const SharedMesh& m) { return to_array(m->input_polygon); })
      .function(
          "texture_coordinates", +[](const SharedMesh& m) { return to_array(m->appearance.texture); })
      .function("notes", &notes)
      .function("summary", &summary)
      .function(
          "points",
          +[](const SharedMesh& m, const val& points) {
            return guarded([&] { return to_points(resolve(m->mesh, "points", points)); });
          })
      .function(
          "positions",
          +[](const SharedMesh& m, const val& points) {
            return guarded([&] { return to_positions(m->mesh, resolve(m->mesh, "points", points)); });
          })
      .function("sample", &sample)
      .function("nearest", &nearest)
      .function("rows", &rows)
      .function("paths", &paths)
      .function("log_map", &log_map)
      .function("isolines", &isolines)
      .function("write", &write_mesh_file);
  emscripten::function("mesh_from_arrays", &mesh_from_arrays);
  emscripten::function("mesh_from_bytes", &mesh_from_bytes);
  emscripten::function(
      "parse_values", +[](const std::string& bytes, const std::string& name) {
        return guarded([&] { return to_array(parse_values(bytes, name)); });
      });
}

}  // namespace gvd::web
