// Exact diagrams whose generators are moved, added and removed one at a time.
#include <algorithm>

#include "gvd/diagram_editor.hpp"
#include "values.hpp"

namespace gvd::web {
namespace {

/// An editor, and the mesh that it reads.
struct EditedMesh {
  SharedMesh input;
  DiagramEditor editor;
};
using SharedEditor = std::shared_ptr<EditedMesh>;

SharedEditor edit(const SharedMesh& input, const val& points, const val& given) {
  return guarded([&] {
    const Given options(input->mesh, given);
    return std::make_shared<EditedMesh>(
        EditedMesh{input, DiagramEditor(input->mesh, resolve(input->mesh, "points", points), options.diagram())});
  });
}

SurfacePoint point_of(const SharedEditor& e, const val& given) {
  const std::vector<SurfacePoint> points = resolve(e->input->mesh, "point", given);
  if (points.size() == 1) return points[0];
  throw Error(ErrorCode::invalid_option, fmt::format("point: one point is needed, not {}", points.size()));
}

/// A whole number >= 0, which may be larger than any id.
GeneratorId id_of(double number) {
  return GeneratorId(std::int32_t(std::min(number, double(std::numeric_limits<std::int32_t>::max()))));
}

void move(const SharedEditor& e, double g, const val& to) {
  guarded([&] { e->editor.move(id_of(g), point_of(e, to)); });
}

void add(const SharedEditor& e, const val& point) {
  guarded([&] { e->editor.add(point_of(e, point)); });
}

void remove(const SharedEditor& e, double g) {
  guarded([&] { e->editor.remove(id_of(g)); });
}

}  // namespace

void bind_editor() {
  emscripten::class_<SharedEditor>("DiagramEditor")
      .function("move", &move)
      .function("add", &add)
      .function("remove", &remove)
      .function(
          "diagram",
          +[](const SharedEditor& e) {
            return MeshDiagram{e->input, std::make_shared<const Diagram>(e->editor.diagram())};
          })
      // The same without a copy, valid until the next change.
      .function(
          "shown",
          +[](const SharedEditor& e) {
            return MeshDiagram{e->input, {e, &e->editor.diagram()}};
          })
      .function(
          "generators", +[](const SharedEditor& e) { return to_points(e->editor.generators()); });
  emscripten::function("edit", &edit);
}

}  // namespace gvd::web
