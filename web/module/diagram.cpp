// Diagrams, their faces labelled or cut, and what a page needs to draw them.
#include "gvd/diagram.hpp"

#include "gvd/check.hpp"
#include "gvd/segment.hpp"
#include "io/view/view_steps.hpp"
#include "values.hpp"

namespace gvd::web {
namespace {

MeshDiagram voronoi(const SharedMesh& input, const val& points, const val& given) {
  return guarded([&] {
    const Given options(input->mesh, given);
    DiagramOptions diagram = options.diagram();
    if (options.has("weights")) diagram.weights = options.numbers("weights");
    return with_sources(input->mesh, points, [&](const auto& generators) {
      return MeshDiagram{input, std::make_shared<const Diagram>(compute_diagram(input->mesh, generators, diagram))};
    });
  });
}

MeshDiagram diagram_inside(const SharedMesh& input, const val& given) {
  return guarded([&] {
    const Given options(input->mesh, given);
    RegionOptions regions;
    LevelOptions level;
    read_regions(options, regions, level);
    level.diagram = options.diagram();
    level.labels.progress = level.generators.sampling.progress = level.diagram.progress;
    return compute_diagram_inside(input, regions, level);
  });
}

val branch_points(const MeshDiagram& of) {
  std::vector<SurfacePoint> points;
  std::vector<Vec3> positions;
  std::vector<double> distances;
  val generators = val::array();
  for (const BranchPoint& branch : of.diagram->branch_points) {
    points.push_back(branch.point);
    positions.push_back(branch.position);
    distances.push_back(branch.distance);
    generators.call<void>("push", to_array(branch.generators));
  }
  return object({{"points", to_points(points)},
                 {"positions", to_array(positions)},
                 {"distances", to_array(distances)},
                 {"generators", generators}});
}

/// All bisectors in one array each: `first` has the place of each one's first point, and at the end their number.
val bisectors(const MeshDiagram& of) {
  std::vector<std::int32_t> first{0}, left, right, closed, ends;
  std::vector<SurfacePoint> points;
  for (const Bisector& b : of.diagram->bisectors) {
    points.insert(points.end(), b.points.begin(), b.points.end());
    first.push_back(std::int32_t(points.size()));
    left.push_back(b.left.value());
    right.push_back(b.right.value());
    closed.push_back(b.closed ? 1 : 0);
    for (const BranchPointId end : b.ends) ends.push_back(end.value());
  }
  return object({{"first", to_array(first)},
                 {"left", to_array(left)},
                 {"right", to_array(right)},
                 {"closed", to_array(closed)},
                 {"ends", to_array(ends)},
                 {"points", to_points(points)},
                 {"positions", to_positions(of.input->mesh, points)}});
}

val cells(const MeshDiagram& of) {
  val list = val::array();
  for (const Cell& cell : of.diagram->cells) {
    list.call<void>("push", object({{"generator", val(cell.generator.value())},
                                    {"area", val(cell.area)},
                                    {"euler_characteristic", val(cell.euler_characteristic)},
                                    {"components", val(cell.components)},
                                    {"boundary_loops", val(cell.boundary_loops)},
                                    {"neighbours", to_array(cell.neighbours)}}));
  }
  return list;
}

/// The faces that bisectors cut, in triangles: nine coordinates of each, its face and its label.
val pieces(const MeshDiagram& of) {
  const Mesh& mesh = of.input->mesh;
  std::vector<float> positions;
  std::vector<FaceId> faces;
  std::vector<GeneratorId> labels;
  for (const FacePiece& piece : of.diagram->pieces) {
    std::vector<Vec2> polygon;
    for (const auto& b : piece.corners) polygon.emplace_back(b[1], b[2]);
    for (const auto& triangle : io::triangulate_polygon(polygon)) {
      for (const std::uint32_t corner : triangle) {
        const Vec3 at = position(mesh, {piece.face, piece.corners[corner]});
        for (int i = 0; i < 3; ++i) positions.push_back(static_cast<float>(at[i]));
      }
      faces.push_back(piece.face);
      labels.push_back(piece.generator);
    }
  }
  return object({{"positions", to_array(positions)}, {"face", to_array(faces)}, {"label", to_array(labels)}});
}

val violations(const MeshDiagram& of) {
  return guarded([&] {
    val list = val::array();
    for (const std::string& line : check_diagram(of.surface(), of.surface_diagram()).violations) {
      list.call<void>("push", line);
    }
    return list;
  });
}

MeshDiagram discs(const MeshDiagram& of, const val& given) {
  return guarded([&] { return make_cells_discs(of, Given(of.mesh(), given).diagram()); });
}

Segmented segment(const MeshDiagram& of, const val& given) {
  return guarded([&] {
    const Given options(of.mesh(), given);
    SegmentOptions chosen;
    options.read("labels", chosen.labels, kFaceLabelNames);
    chosen.progress = options.progress();
    return segment_diagram(of, chosen);
  });
}

Cut cut(const MeshDiagram& of, const val& given) {
  return guarded([&] {
    const Given options(of.mesh(), given);
    std::optional<ChartMap> charts;
    options.read("uv", charts, kChartMapNames);
    return cut_diagram(of, charts, options.progress());
  });
}

/// The numbers of the faces inside regions, by their names.
val numbers(const Segmented& made) {
  val found = val::object();
  for (const FaceNumbers& each : made.numbers) found.set(each.name, to_array(each.values));
  return found;
}

val charts(const Cut& made) {
  val list = val::array();
  const auto pair = [](const Vec2& p) { return val::array(std::vector{p.x(), p.y()}); };
  for (const Chart& chart : made.charts.charts) {
    list.call<void>("push", object({{"label", val(chart.generator.value())},
                                    {"faces", val(double(chart.faces))},
                                    {"area", val(chart.area)},
                                    {"flipped_area", val(chart.flipped_area)},
                                    {"torn_area", val(chart.torn_area)},
                                    {"unplaced_area", val(chart.unplaced_area)},
                                    {"stretch", val(chart.stretch)},
                                    {"box", val::array(std::vector{pair(chart.box.min()), pair(chart.box.max())})},
                                    {"origin", pair(chart.origin)}}));
  }
  return list;
}

/// The bytes of a result's file.
template <class Result>
val write(const Result& result, const std::string& format, const val& given) {
  return guarded([&] {
    const LabelledMesh mesh = labelled(result);
    return write_result(mesh, format, Given(mesh.mesh, given), own_formats(result));
  });
}

void bind_parts() {
  emscripten::class_<Segmented>("Segmentation")
      .function(
          "labels", +[](const Segmented& s) { return to_array(s.segmentation.face_label); })
      .function(
          "without_face", +[](const Segmented& s) { return to_array(s.segmentation.without_face); })
      .function(
          "border_length",
          +[](const Segmented& s) { return compute_border_length(s.of.surface(), s.segmentation.face_label); })
      .function("numbers", &numbers)
      .function("write", &write<Segmented>);
  emscripten::class_<Cut>("Cut")
      .function("mesh", &Cut::mesh)
      .function("charts", &charts)
      .function(
          "scale", +[](const Cut& c) { return c.charts.scale; })
      .function(
          "labels", +[](const Cut& c) { return to_array(c.cut.label); })
      .function(
          "parents", +[](const Cut& c) { return to_array(c.cut.parent); })
      .function(
          "vertex_labels", +[](const Cut& c) { return to_array(c.vertices.label); })
      .function(
          "distances", +[](const Cut& c) { return to_array(c.vertices.distance); })
      .function("write", &write<Cut>);
}

}  // namespace

void bind_diagram() {
  emscripten::class_<MeshDiagram>("Diagram")
      .function(
          "labels", +[](const MeshDiagram& d) { return to_array(d.diagram->vertex_label); })
      .function(
          "distances", +[](const MeshDiagram& d) { return to_array(d.diagram->vertex_distance); })
      .function(
          "face_labels", +[](const MeshDiagram& d) { return to_array(d.diagram->face_label); })
      .function(
          "weights", +[](const MeshDiagram& d) { return to_array(d.diagram->weights); })
      .function(
          "generators", +[](const MeshDiagram& d) { return to_points(d.diagram->generators); })
      .function(
          "length", +[](const MeshDiagram& d) { return d.diagram->length; })
      .function("branch_points", &branch_points)
      .function("bisectors", &bisectors)
      .function("cells", &cells)
      .function("pieces", &pieces)
      .function("check", &violations)
      .function("discs", &discs)
      .function("segment", &segment)
      .function("cut", &cut)
      .function("write", &write<MeshDiagram>);
  bind_parts();
  emscripten::function("voronoi", &voronoi);
  emscripten::function("diagram_inside", &diagram_inside);
}

}  // namespace gvd::web
