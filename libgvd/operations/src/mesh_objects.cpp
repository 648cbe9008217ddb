// Objects that are meshes and diagrams.
#include "gvd/mesh_objects.hpp"

#include <algorithm>
#include <mutex>
#include <ostream>

#include "figures.hpp"
#include "gvd/error.hpp"
#include "gvd/generator_list.hpp"
#include "gvd/io/diagram_json.hpp"
#include "gvd/mesh.hpp"
#include "gvd/parted_mesh.hpp"
#include "io/view/scene_entry.hpp"

namespace gvd {
namespace {

std::int64_t count_disc_cells(const Diagram& diagram) { return std::ranges::count_if(diagram.cells, &Cell::is_disc); }

/// Makes an object of the triangles of the faces that bisectors cut.
std::shared_ptr<const Object> make_pieces(const Mesh& mesh, const Diagram& diagram) {
  std::vector<Vec3> positions;
  std::vector<FaceId> faces;
  std::vector<GeneratorId> labels;
  for (const FacePiece& piece : diagram.pieces) {
    std::vector<Vec2> polygon;
    for (const auto& b : piece.corners) polygon.emplace_back(b[1], b[2]);
    for (const auto& triangle : io::triangulate_polygon(polygon)) {
      for (const std::uint32_t corner : triangle) {
        positions.push_back(position(mesh, {piece.face, piece.corners[corner]}));
      }
      faces.push_back(piece.face);
      labels.push_back(piece.generator);
    }
  }
  return std::make_shared<PlainObject>("pieces", [positions = std::move(positions), faces = std::move(faces),
                                                  labels = std::move(labels)](ObjectVisitor& visitor) {
    visitor.array({"positions", "mesh units", "of three corners each"}, view(positions));
    visitor.array({"faces", "", "face of each triangle"}, view(faces));
    visitor.array({"labels", "", "the generator of each triangle"}, view(labels));
  });
}

}  // namespace

void visit_summary(ObjectVisitor& visitor, const MeshSummary& mesh, const std::string& group) {
  const Figures figure(visitor, group);
  figure("vertices", "", "number of vertices", mesh.vertices);
  figure("faces", "", "number of triangles", mesh.faces);
  figure("components", "", "connected parts", mesh.components);
  figure("boundary_loops", "", "loops of boundary edges", mesh.boundary_loops);
  figure("euler_characteristic", "", "vertices - edges + faces", mesh.euler_characteristic);
  figure("area", "square mesh units", "of all faces", mesh.area);
}

void visit_figures(ObjectVisitor& visitor, const Diagram& diagram) {
  const Figures figure(visitor);
  const DiagramReport& report = diagram.report;
  figure("branch_points", "", "points of three or more cells", diagram.branch_points.count());
  figure("bisectors", "", "curves between two cells", diagram.bisectors.count());
  figure("length", "mesh units", "of all bisectors", diagram.length);
  figure("cells", "", "generators", diagram.cells.count());
  figure("disc_cells", "", "cells that are discs", count_disc_cells(diagram));
  figure("trivial_faces", "", "faces whose corners have one nearest generator", report.face_classes.trivial);
  figure("ordinary_faces", "", "faces whose corners have two", report.face_classes.ordinary);
  figure("branching_faces", "", "faces whose corners have three", report.face_classes.branching);
  figure("gaps", "", "connected sets of faces with three or more generators", report.gaps);
  figure("gaps_grown", "", "gaps that growth closed", report.gaps_grown);
  figure("gaps_assembled", "", "gaps that were closed from the crossings of edges", report.gaps_assembled);
  figure("unresolved_ends", "", "ends of bisectors at no branch point and not on the boundary", report.unresolved_ends);
  figure("relabelled_vertices", "", "vertices with another label than the nearest generator",
         report.relabelled_vertices);
  figure("straightened_faces", "", "faces in which bisectors are straightened", report.straightened_faces);
  figure("straightened_error", "mesh units", "largest difference of the two distances there",
         report.straightened_error);
}

struct DiagramObject::KeptEditor {
  std::mutex mutex;
  std::unique_ptr<DiagramEditor> editor;  // refers to the mesh
};

DiagramObject::DiagramObject(MeshPtr mesh, std::shared_ptr<const Diagram> diagram,
                             std::optional<DiagramOptions> options, std::shared_ptr<const PartedMesh> parted)
    : mesh_(std::move(mesh)),
      parted_(parted ? std::move(parted) : std::make_shared<const PartedMesh>()),
      of_surface_(std::move(diagram)),
      diagram_(parted_->on_input(of_surface_)),
      options_(parted_->is_parted() ? std::nullopt : std::move(options)),
      kept_(std::make_shared<KeptEditor>()) {}

std::unique_ptr<DiagramEditor> DiagramObject::take_editor(Observer& observer) const {
  std::unique_ptr<DiagramEditor> editor;
  {
    const std::lock_guard lock(kept_->mutex);
    editor = std::move(kept_->editor);
  }
  if (editor) {
    editor->run_with(observer.threads, progress_of(observer));
    return editor;
  }
  if (!options_) throw Error(ErrorCode::invalid_option, "a diagram inside regions can't be edited");
  if (!diagram_->curves.empty()) throw Error(ErrorCode::invalid_option, "a diagram of curves can't be edited");
  DiagramOptions options = *options_;
  options.weights = diagram_->weights;
  options.threads = observer.threads;
  options.progress = progress_of(observer);
  return std::make_unique<DiagramEditor>(mesh_->mesh, diagram_->generators, std::move(options));
}

void DiagramObject::keep(std::unique_ptr<DiagramEditor> editor) const {
  editor->run_with(0, {});  // the observer does not outlive its call
  const std::lock_guard lock(kept_->mutex);
  kept_->editor = std::move(editor);
}

void MeshObject::visit(ObjectVisitor& visitor) const {
  const Mesh& mesh = mesh_->mesh;
  const MeshSummary summary = compute_mesh_summary(mesh);
  const Figures figure(visitor);
  visit_summary(visitor, summary);
  figure("edges", "", "number of edges", summary.edges);
  figure("bbox_diagonal", "mesh units", "diagonal of the bounding box", summary.bbox_diagonal);
  figure("repairs", "", "what was repaired, a line each", mesh_->defects.messages);
  const Appearance& look = mesh_->appearance;
  figure("materials", "", "names of materials", look.materials);
  figure("material_files", "", "files with the materials", look.material_files);
  visitor.array({"vertex_positions", "mesh units", "x, y and z of each vertex"}, view(mesh.positions()));
  visitor.array({"face_vertices", "", "the vertices of each face"}, view(mesh.face_vertices()));
  visitor.array({"vertex_of_input", "", "the vertex that each vertex of the input became; -1: none"},
                view(mesh_->mesh_vertex));
  visitor.array({"input_vertex", "", "the vertex of the input that each vertex was; -1: the middle of a split edge"},
                view(mesh_->input_vertex));
  visitor.array({"input_polygon", "", "the polygon of the input that each face was part of"},
                view(mesh_->input_polygon));
  visitor.array({"texture", "", "u and v of the three corners of each face; not a number where there are none"},
                view(look.texture));
  visitor.array({"face_materials", "", "index of each face's material among the names; -1: none"}, view(look.material));
}

const Mesh& DiagramObject::surface() const { return parted_->surface(mesh_->mesh); }

void DiagramObject::visit(ObjectVisitor& visitor) const {
  const Diagram& diagram = *diagram_;
  const auto& cells = diagram.cells.raw();
  const auto& branch_points = diagram.branch_points.raw();
  const auto& bisectors = diagram.bisectors.raw();
  visit_figures(visitor, diagram);
  visitor.points({"generators", "", "the generators; of a curve its first point"}, diagram.generators);
  visitor.array({"weights", "mesh units", "of the generators; empty: 0 for all"}, view(diagram.weights));
  visitor.array({"vertex_labels", "", "the nearest generator of each vertex; -1: none"}, view(diagram.vertex_label));
  visitor.array({"vertex_distances", "mesh units", "the distance from it"}, view(diagram.vertex_distance));
  visitor.array({"face_labels", "", "the generator of each whole face; -1: cut, or reached by none"},
                view(diagram.face_label));
  visitor.array({"cell_areas", "square mesh units", "of the cell of each generator"}, view(cells, &Cell::area));
  visitor.array({"cell_euler_characteristics", "", "1 for a disc, 0 for an annulus"},
                view(cells, &Cell::euler_characteristic));
  visitor.array({"cell_components", "", "1 for a cell that is connected"}, view(cells, &Cell::components));
  visitor.array({"cell_boundary_loops", "", "loops of bisectors and of the mesh's boundary"},
                view(cells, &Cell::boundary_loops));
  visitor.lists({"cell_neighbours", "", "cells with a bisector in common, ascending"},
                lists_of(cells, &Cell::neighbours));
  visitor.points({"branch_point", "", "points of three or more cells"}, {branch_points, &BranchPoint::point});
  visitor.array({"branch_point_positions", "mesh units", "their positions"},
                view(branch_points, &BranchPoint::position));
  visitor.array({"branch_point_distances", "mesh units", "their distances from the generators"},
                view(branch_points, &BranchPoint::distance));
  visitor.lists({"branch_point_generators", "", "their generators, counter-clockwise"},
                lists_of(branch_points, &BranchPoint::generators));
  visitor.array({"bisector_left", "", "the cell on the left of each bisector, seen from outside"},
                view(bisectors, &Bisector::left));
  visitor.array({"bisector_right", "", "the cell on its right"}, view(bisectors, &Bisector::right));
  visitor.array({"bisector_closed", "", "1 for a loop"}, view(bisectors, &Bisector::closed));
  visitor.array({"bisector_ends", "", "the branch points at both ends; -1 on the boundary, and of a loop"},
                view(bisectors, &Bisector::ends));
  visitor.curves({"bisector", "", "the points of each bisector, both ends included"},
                 lists_of(bisectors, &Bisector::points));
  visitor.part({"pieces", "", "the faces that bisectors cut, in triangles"}, "pieces",
               [this] { return make_pieces(mesh_->mesh, *diagram_); });
}

std::optional<LabelledMesh> MeshObject::labelled() const {
  LabelledMesh mesh{mesh_->mesh};
  mesh.appearance = &mesh_->appearance;
  return mesh;
}

std::optional<LabelledMesh> DiagramObject::labelled() const {
  LabelledMesh mesh = label_mesh(mesh_->mesh, *diagram_, of_surface_->face_label);
  if (parted_->is_parted()) {
    mesh.diagram = of_surface_.get();
    mesh.diagram_mesh = &surface();
  }
  mesh.appearance = &mesh_->appearance;
  return mesh;
}

OwnWriters DiagramObject::own_writers() const {
  const auto list = [this](GeneratorFormat format) {
    return [this, format](std::ostream& out) { out << format_generators(mesh_->mesh, diagram_->generators, format); };
  };
  return {{"txt", list(GeneratorFormat::text)},
          {"csv", list(GeneratorFormat::csv)},
          {"json", [this](std::ostream& out) { write_diagram_json(out, mesh_->mesh, *diagram_); }}};
}

}  // namespace gvd
