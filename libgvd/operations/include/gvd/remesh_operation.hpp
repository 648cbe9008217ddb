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
  bool map = false;                      ///< map the input's vertices to the remesh and back
  bool carry = false;                    ///< carry over texture coordinates, materials and `properties`
  std::vector<MeshProperty> properties;  ///< the properties of the input's file
};

/// Describes the options except `map` and `carry`, because the command has options of its own for the files with these
/// results. `describe_for_programs` describes these.
void describe(OptionList& list, RemeshCall& call);
void describe_for_programs(OptionList& list, RemeshCall& call);

/// The result of `remesh`: a coarse mesh with its diagram.
class RemeshOutcome : public Object {
 public:
  static constexpr Content kContent = Content::surface | Content::diagram;
  /// The content that `carry` takes over from the input.
  static constexpr Content kCarried = Content::properties | Content::texture | Content::materials;
  std::string_view kind() const override { return "remesh"; }
  Content content() const override { return kContent; }
  void check_file(const WrittenFile& file) const override;
  void visit(ObjectVisitor& visitor) const override;
  const RemeshResult& result() const { return made->result; }
  std::optional<LabelledMesh> labelled() const override;
  OwnWriters own_writers() const override;
  /// `part` is "map" for the map of the vertices.
  OwnWriters part_writers(std::string_view part) const override;
  std::string page(const FileOptions& options) const override;

  MeshPtr input = std::make_shared<CheckedMesh>();
  std::shared_ptr<const SurfaceRemesh> made = std::make_shared<SurfaceRemesh>();
  DiagramOptions options;                ///< the options of the diagram
  std::optional<Fewest> search;          ///< the search for the fewest generators, if `error` is given
  double search_distance = 0;            ///< the distance that the search had to keep, mesh units
  std::optional<RemeshMap> map;          ///< if the options ask for it
  bool carries = false;                  ///< whether the options ask for `properties` and `appearance`
  std::vector<MeshProperty> properties;  ///< carried over
  Appearance appearance;                 ///< carried over
  /// How far each listed generator was moved to the surface; nothing for a generator that the relaxation moved.
  std::vector<std::optional<double>> snap_distance;
};

/// The operation `map` has no options.
struct MapCall {};
inline void describe(OptionList&, MapCall&) {}

/// Adds the map of the vertices to a remesh, as `map` of RemeshCall does. Throws what `map_to_remesh` throws.
std::shared_ptr<const RemeshOutcome> run(const RemeshOutcome& on, MapCall& call, Observer& observer);

/// The notes on a remesh, one line each. `options`: the options that gave the result.
std::vector<std::string> describe_remesh(const RemeshResult& result, const RemeshOptions& options);

/// Chooses and relaxes generators, and builds the coarse mesh of their diagram. Replaces options such as `auto` in
/// `call` by the values used. Throws what `choose_generators`, `find_remesh_count`, `remesh_surface` and
/// `map_to_remesh` throw.
std::shared_ptr<const RemeshOutcome> run(const MeshPtr& input, RemeshCall& call, Observer& observer);

}  // namespace gvd
