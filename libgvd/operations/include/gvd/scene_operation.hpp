#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "gvd/given_values.hpp"
#include "gvd/io/label_color.hpp"
#include "gvd/object.hpp"
#include "gvd/observer.hpp"
#include "gvd/option_list.hpp"

namespace gvd {

/// The kinds of objects that have a scene, in words for messages.
inline constexpr std::string_view kSceneSubjects = "diagram, distances or remesh";

/// The options of the operation `scene`, which works on a diagram, on distances or on a remesh.
struct SceneCall {
  GivenNumbers colors;        ///< of the regions of a scene before: red, green and blue of each; none: chosen anew
  std::int32_t isolines = 0;  ///< levels up to the largest distance, of distances; 0: the isolines that they have
};

void describe(OptionList& list, SceneCall& call);

/// A picture for the page, as `--view` writes it into one: docs/developer/viewer.md has the members of the manifest.
class SceneObject : public Object {
 public:
  std::string_view kind() const override { return "scene"; }
  void visit(ObjectVisitor& visitor) const override;

  std::string manifest;               ///< JSON, with the number of an array wherever it refers to one
  std::string bytes;                  ///< of all arrays
  std::vector<std::int64_t> offsets;  ///< the place of each array's first byte, and the number of all
  std::vector<Rgb> colors;            ///< of the regions
};

/// Makes the scene in the coordinates of the mesh that the object was made of, so that scenes of one mesh follow each
/// other. Regions keep the given colours as far as their neighbours allow. Throws Error{invalid_option} for an object
/// of another kind, Error{precondition} for what does not fit its mesh. Cost: O(n log n).
std::shared_ptr<const SceneObject> run(const Object& on, SceneCall& call, Observer& observer);

}  // namespace gvd
