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

// Meshes and diagrams as objects.
namespace gvd {

/// The mesh that an operation works on, with what is known of its file. Results keep it alive.
using MeshPtr = std::shared_ptr<const CheckedMesh>;

/// The figures of meshes, in reports, too; the name of each begins with that of the group.
void visit_summary(ObjectVisitor& visitor, const MeshSummary& mesh, const std::string& group = "");
/// The figures of diagrams.
void visit_figures(ObjectVisitor& visitor, const Diagram& diagram);

/// An object that consists of what a function tells, and has no file.
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

class DiagramObject : public Object {
 public:
  static constexpr Content kContent =
      Content::surface | Content::vertex_labels | Content::distances | Content::diagram | Content::generators;
  DiagramObject() : DiagramObject(std::make_shared<CheckedMesh>(), std::make_shared<Diagram>(), {}) {}
  /// `diagram`: of the surface. `options`: those that made it. `parted`: the regions that it keeps to; null: none.
  DiagramObject(MeshPtr mesh, std::shared_ptr<const Diagram> diagram, std::optional<DiagramOptions> options,
                std::shared_ptr<const PartedMesh> parted = nullptr);
  const MeshPtr& mesh() const { return mesh_; }
  const PartedMesh& parted() const { return *parted_; }
  /// The mesh and the diagram that has all of its vertices (PartedMesh::surface).
  const Mesh& surface() const;
  const std::shared_ptr<const Diagram>& of_surface() const { return of_surface_; }
  /// The diagram with the vertices of the mesh alone: another one inside regions.
  const Diagram& diagram() const { return *diagram_; }
  /// None inside regions.
  const std::optional<DiagramOptions>& options() const { return options_; }
  std::string_view kind() const override { return "diagram"; }
  Content content() const override { return kContent; }
  void visit(ObjectVisitor& visitor) const override;
  std::optional<LabelledMesh> labelled() const override;
  OwnWriters own_writers() const override;

  /// An editor of the diagram, which is the caller's then: that of `keep`, or a new one, which computes the diagram
  /// again. Throws what DiagramEditor throws, and Error{invalid_option} for diagrams of curves and inside regions.
  std::unique_ptr<DiagramEditor> take_editor(Observer& observer) const;
  /// Keeps an editor for the next one who takes it. Several threads may take and keep at once.
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
