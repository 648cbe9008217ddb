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

/// The kinds of objects that have a scene, for messages.
inline constexpr std::string_view kSceneSubjects = "diagram, distances or remesh";

/// The options of the operation `scene`, which works on a diagram, on distances or on a remesh.
struct SceneCall {
  GivenNumbers colors;  ///< red, green and blue of each region in the previous scene; none: new colours are chosen
  /// For distances, the number of levels up to the largest distance; 0: the isolines that they have.
  std::int32_t isolines = 0;
};

void describe(OptionList& list, SceneCall& call);

/// The result of `scene`: a picture for the page, as `--view` writes it. docs/developer/viewer.md lists the members of
/// the manifest.
class SceneObject : public Object {
 public:
  std::string_view kind() const override { return "scene"; }
  void visit(ObjectVisitor& visitor) const override;

  std::string manifest;               ///< JSON, which refers to arrays by number
  std::string bytes;                  ///< the bytes of all arrays
  std::vector<std::int64_t> offsets;  ///< the index of each array's first byte, and the number of all bytes
  std::vector<Rgb> colors;            ///< of the regions
};

/// Makes the scene in the coordinates of the mesh from which the object was made, so that scenes of the same mesh can
/// replace each other. Regions keep the given colours as far as their neighbours allow. Throws Error{invalid_option}
/// for an object of another kind, and Error{precondition} for an object that does not fit its mesh. Cost: O(n log n).
std::shared_ptr<const SceneObject> run(const Object& on, SceneCall& call, Observer& observer);

}  // namespace gvd
