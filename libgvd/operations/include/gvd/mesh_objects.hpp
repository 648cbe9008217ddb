#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/object.hpp"
#include "gvd/soup.hpp"

// Meshes and diagrams as objects.
namespace gvd {

/// The mesh that an operation works on, with what is known of its file. Results keep it alive.
using MeshPtr = std::shared_ptr<const CheckedMesh>;

/// Writers of a list of points.
OwnWriters list_writers(const Mesh& mesh, const std::vector<SurfacePoint>& points);

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

class DiagramObject : public Object {
 public:
  static constexpr Content kContent =
      Content::surface | Content::vertex_labels | Content::distances | Content::diagram | Content::generators;
  DiagramObject() = default;
  DiagramObject(MeshPtr mesh, std::shared_ptr<const Diagram> diagram)
      : mesh_(std::move(mesh)), diagram_(std::move(diagram)) {}
  const MeshPtr& mesh() const { return mesh_; }
  const Diagram& diagram() const { return *diagram_; }
  const std::shared_ptr<const Diagram>& shared() const { return diagram_; }
  std::string_view kind() const override { return "diagram"; }
  Content content() const override { return kContent; }
  void visit(ObjectVisitor& visitor) const override;
  std::optional<LabelledMesh> labelled() const override;
  OwnWriters own_writers() const override;

 private:
  MeshPtr mesh_ = std::make_shared<CheckedMesh>();
  std::shared_ptr<const Diagram> diagram_ = std::make_shared<Diagram>();
};

}  // namespace gvd
