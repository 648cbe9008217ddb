// Diagrams, their faces labelled or cut, and what a page needs to draw them.
#include "gvd/diagram.hpp"

#include "gvd/check.hpp"
#include "gvd/generator_list.hpp"
#include "gvd/io/diagram_json.hpp"
#include "gvd/segment.hpp"
#include "io/view/view_steps.hpp"
#include "values.hpp"

namespace gvd::web {
namespace {

struct Segmented {
  MeshDiagram of;
  std::shared_ptr<const Segmentation> made;
};

struct Cut {
  MeshDiagram of;
  std::shared_ptr<const CutMesh> mesh;
  std::shared_ptr<const CutVertices> vertices;
  std::shared_ptr<const Appearance> appearance;
};

MeshDiagram voronoi(const SharedMesh& input, const val& points, const val& given) {
  return guarded([&] {
    const Given options(input->mesh, given);
    DiagramOptions diagram = options.diagram();
    if (options.has("weights")) diagram.weights = options.numbers("weights");
    const auto generators = resolve(input->mesh, "points", points);
    return MeshDiagram{input, std::make_shared<const Diagram>(compute_diagram(input->mesh, generators, diagram))};
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
    for (const std::string& line : check_diagram(of.input->mesh, *of.diagram).violations) {
      list.call<void>("push", line);
    }
    return list;
  });
}

val write_diagram(const MeshDiagram& of, const std::string& format, const val& given) {
  return guarded([&] {
    const Mesh& mesh = of.input->mesh;
    const auto list = [&](GeneratorFormat kind) {
      return [&mesh, &of, kind](std::ostream& out) { out << format_generators(mesh, of.diagram->generators, kind); };
    };
    LabelledMesh labelled = label_mesh(mesh, *of.diagram, of.diagram->face_label);
    labelled.appearance = &of.input->appearance;
    return write_result(labelled, format, Given(mesh, given),
                        {{"json", [&](std::ostream& out) { write_diagram_json(out, mesh, *of.diagram); }},
                         {"txt", list(GeneratorFormat::text)},
                         {"csv", list(GeneratorFormat::csv)}});
  });
}

Segmented segment(const MeshDiagram& of, const val& given) {
  return guarded([&] {
    const Given options(of.input->mesh, given);
    SegmentOptions chosen;
    options.read("labels", chosen.labels, kFaceLabelNames);
    chosen.progress = options.progress();
    return Segmented{of, std::make_shared<const Segmentation>(segment_faces(of.input->mesh, *of.diagram, chosen))};
  });
}

val write_segmented(const Segmented& s, const std::string& format, const val& given) {
  return guarded([&] {
    const Mesh& mesh = s.of.input->mesh;
    LabelledMesh labelled = label_mesh(mesh, *s.of.diagram, s.made->face_label);
    labelled.appearance = &s.of.input->appearance;
    return write_result(
        labelled, format, Given(mesh, given),
        {{"json", [&](std::ostream& out) { write_segmentation_json(out, mesh, *s.of.diagram, *s.made); }}});
  });
}

Cut cut(const MeshDiagram& of, const val& given) {
  return guarded([&] {
    const Mesh& mesh = of.input->mesh;
    auto faces = std::make_shared<const CutMesh>(cut_faces(mesh, *of.diagram, Given(mesh, given).progress()));
    return Cut{of, faces, std::make_shared<const CutVertices>(carry_to_cut_vertices(mesh, *of.diagram, *faces)),
               std::make_shared<const Appearance>(carry_to_cut_faces(mesh, of.input->appearance, *faces))};
  });
}

val write_cut(const Cut& c, const std::string& format, const val& given) {
  return guarded([&] {
    const Mesh& surface = c.of.input->mesh;
    LabelledMesh labelled{c.mesh->mesh,          &c.mesh->label,     &c.mesh->parent, &c.vertices->label,
                          &c.vertices->distance, c.of.diagram.get(), &surface};
    labelled.appearance = c.appearance.get();
    return write_result(
        labelled, format, Given(surface, given),
        {{"json", [&](std::ostream& out) { write_cut_json(out, surface, *c.of.diagram, *c.mesh, *c.vertices); }}});
  });
}

void bind_parts() {
  emscripten::class_<Segmented>("Segmentation")
      .function(
          "labels", +[](const Segmented& s) { return to_array(s.made->face_label); })
      .function(
          "without_face", +[](const Segmented& s) { return to_array(s.made->without_face); })
      .function(
          "border_length",
          +[](const Segmented& s) { return compute_border_length(s.of.input->mesh, s.made->face_label); })
      .function("write", &write_segmented);
  emscripten::class_<Cut>("Cut")
      .function(
          "mesh",
          +[](const Cut& c) {
            auto mesh = std::make_shared<CheckedMesh>(as_input(c.mesh->mesh));
            mesh->appearance = *c.appearance;
            return mesh;
          })
      .function(
          "labels", +[](const Cut& c) { return to_array(c.mesh->label); })
      .function(
          "parents", +[](const Cut& c) { return to_array(c.mesh->parent); })
      .function(
          "vertex_labels", +[](const Cut& c) { return to_array(c.vertices->label); })
      .function(
          "distances", +[](const Cut& c) { return to_array(c.vertices->distance); })
      .function("write", &write_cut);
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
      .function("segment", &segment)
      .function("cut", &cut)
      .function("write", &write_diagram);
  bind_parts();
  emscripten::function("voronoi", &voronoi);
}

}  // namespace gvd::web
