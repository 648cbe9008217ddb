#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "gvd/appearance.hpp"
#include "gvd/find_fewest.hpp"
#include "gvd/generator_options.hpp"
#include "gvd/io/mesh_writer.hpp"
#include "gvd/mesh_objects.hpp"
#include "gvd/mesh_property.hpp"
#include "gvd/observer.hpp"
#include "gvd/option_list.hpp"
#include "gvd/relaxation_parts.hpp"
#include "gvd/remesh_map.hpp"
#include "gvd/remesh_surface.hpp"

namespace gvd {

/// The options of the operation `remesh`.
struct RemeshCall {
  GeneratorOptions generators;
  DiagramOptions diagram;
  GivenConstraints constraints;
  SurfaceRemeshOptions remesh;
  bool map = false;                      ///< map the vertices of the input to the remesh, and back
  bool carry = false;                    ///< carry texture coordinates and materials over, and `properties`
  std::vector<MeshProperty> properties;  ///< of the input's file
};

/// Describes them, but for `map` and `carry`: a command has options of its own for what it writes of these.
void describe(OptionList& list, RemeshCall& call);
/// Describes the rest.
void describe_for_programs(OptionList& list, RemeshCall& call);

/// A coarse mesh with its diagram.
class RemeshOutcome : public Object {
 public:
  static constexpr Content kContent = Content::surface | Content::diagram;
  /// What `carry` takes from the input.
  static constexpr Content kCarried = Content::properties | Content::texture | Content::materials;
  std::string_view kind() const override { return "remesh"; }
  Content content() const override { return kContent; }
  void check_file(const WrittenFile& file) const override;
  void visit(ObjectVisitor& visitor) const override;
  const RemeshResult& result() const { return made->result; }
  std::optional<LabelledMesh> labelled() const override;
  OwnWriters own_writers() const override;
  /// "map": that of the vertices.
  OwnWriters part_writers(std::string_view part) const override;
  std::string page(const FileOptions& options) const override;

  MeshPtr input = std::make_shared<CheckedMesh>();
  std::shared_ptr<const SurfaceRemesh> made = std::make_shared<SurfaceRemesh>();
  DiagramOptions options;                ///< of the diagram
  std::optional<Fewest> search;          ///< for the fewest generators
  double search_distance = 0;            ///< that was asked for, mesh units
  std::optional<RemeshMap> map;          ///< where it was asked for
  bool carries = false;                  ///< whether what follows was asked for
  std::vector<MeshProperty> properties;  ///< carried over
  Appearance appearance;                 ///< carried over
  /// How far each generator is from where it was given; nothing for one that is somewhere else now.
  std::vector<std::optional<double>> snap_distance;
};

/// The options of the operation `map`: there are none.
struct MapCall {};
inline void describe(OptionList&, MapCall&) {}

/// A remesh with its map.
std::shared_ptr<const RemeshOutcome> run(const RemeshOutcome& on, MapCall& call, Observer& observer);

/// The notes on a remesh, one line each. `options`: those that gave the result.
std::vector<std::string> describe_remesh(const RemeshResult& result, const RemeshOptions& options);

/// Chooses and relaxes generators, and builds the coarse mesh of their diagram. Options become what they stand for.
/// Throws what choose_generators, find_remesh_count, remesh_surface and map_to_remesh throw.
std::shared_ptr<const RemeshOutcome> run(const MeshPtr& input, RemeshCall& call, Observer& observer);

}  // namespace gvd
