#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/diagram_editor.hpp"
#include "gvd/mesh.hpp"
#include "gvd/object.hpp"
#include "gvd/observer.hpp"
#include "gvd/soup.hpp"

// Objects that are meshes and diagrams.
namespace gvd {

/// The mesh that an operation works on, with its relation to the file. Results keep it alive.
using MeshPtr = std::shared_ptr<const CheckedMesh>;

/// Visits the figures of a mesh, whose names begin with the name of the group. Reports use them, too.
void visit_summary(ObjectVisitor& visitor, const MeshSummary& mesh, const std::string& group = "");
/// Visits the figures of a diagram.
void visit_figures(ObjectVisitor& visitor, const Diagram& diagram);

/// An object whose parts a function visits, and that has no file.
class PlainObject : public Object {
 public:
  PlainObject(std::string_view kind, std::function<void(ObjectVisitor&)> visit)
      : kind_(kind), visit_(std::move(visit)) {}
  std::string_view kind() const override { return kind_; }
  void visit(ObjectVisitor& visitor) const override { visit_(visitor); }

 private:
  std::string_view kind_;
  std::function<void(ObjectVisitor&)> visit_;
};

/// A mesh as an object. It shares the CheckedMesh, which it keeps alive.
class MeshObject : public Object {
 public:
  MeshObject() = default;
  static constexpr Content kContent = Content::surface;
  explicit MeshObject(MeshPtr mesh) : mesh_(std::move(mesh)) {}
  const MeshPtr& mesh() const { return mesh_; }
  std::string_view kind() const override { return "mesh"; }
  Content content() const override { return kContent; }
  void visit(ObjectVisitor& visitor) const override;
  std::optional<LabelledMesh> labelled() const override;

 private:
  MeshPtr mesh_ = std::make_shared<CheckedMesh>();
};

struct PartedMesh;

/// A diagram as an object, with its mesh and the regions that it keeps to.
///
/// Properties: (1) mesh and diagrams never change; (2) without regions, `of_surface()` and `diagram()` are the same, and
/// `surface()` is the mesh; (3) at most one editor is kept. Taking and keeping it is safe from any thread.
class DiagramObject : public Object {
 public:
  static constexpr Content kContent =
      Content::surface | Content::vertex_labels | Content::distances | Content::diagram | Content::generators;
  DiagramObject() : DiagramObject(std::make_shared<CheckedMesh>(), std::make_shared<Diagram>(), {}) {}
  /// `diagram` is the diagram of the surface, and `options` are the options that made it. `parted`: the regions that it
  /// keeps to; null for none.
  DiagramObject(MeshPtr mesh, std::shared_ptr<const Diagram> diagram, std::optional<DiagramOptions> options,
                std::shared_ptr<const PartedMesh> parted = nullptr);
  const MeshPtr& mesh() const { return mesh_; }
  const PartedMesh& parted() const { return *parted_; }
  /// The mesh of the diagram (PartedMesh::surface), and the diagram with all vertices of this mesh.
  const Mesh& surface() const;
  const std::shared_ptr<const Diagram>& of_surface() const { return of_surface_; }
  /// The diagram with the vertices of `mesh()` only, which differs from `of_surface()` inside regions.
  const Diagram& diagram() const { return *diagram_; }
  /// The options that made the diagram; nothing inside regions.
  const std::optional<DiagramOptions>& options() const { return options_; }
  std::string_view kind() const override { return "diagram"; }
  Content content() const override { return kContent; }
  void visit(ObjectVisitor& visitor) const override;
  std::optional<LabelledMesh> labelled() const override;
  OwnWriters own_writers() const override;

  /// Passes an editor of the diagram to the caller: the kept one, or a new one, which computes the diagram again.
  /// Throws what DiagramEditor throws, and Error{invalid_option} for diagrams of curves and inside regions.
  std::unique_ptr<DiagramEditor> take_editor(Observer& observer) const;
  /// Keeps an editor for the next call of `take_editor`. Several threads may take and keep editors at the same time.
  void keep(std::unique_ptr<DiagramEditor> editor) const;

 private:
  struct KeptEditor;

  MeshPtr mesh_;
  std::shared_ptr<const PartedMesh> parted_;  // never null
  std::shared_ptr<const Diagram> of_surface_, diagram_;
  std::optional<DiagramOptions> options_;
  std::shared_ptr<KeptEditor> kept_;
};

}  // namespace gvd
