#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "gvd/mesh_objects.hpp"
#include "gvd/object.hpp"
#include "gvd/observer.hpp"
#include "gvd/option_list.hpp"

// The operations of the library as its doors call them: each takes options and returns an object.
namespace gvd {

/// One call of an operation, with its options.
class Call {
 public:
  virtual ~Call() = default;
  /// Describes the options, whose values this object holds.
  virtual void describe(OptionList& list) = 0;
  /// Takes arrays to which no option refers. They must stay valid until `run` has returned.
  virtual void take(std::span<const ArrayView> /*arrays*/) {}
  /// Runs the operation on an object of the kind that it takes. Call it only once, because options such as `auto` are
  /// replaced by the values used.
  /// Throws Error{invalid_option} for an object of another kind, and what the operation throws.
  virtual std::shared_ptr<const Object> run(const std::shared_ptr<const Object>& on, Observer& observer) = 0;
};

struct Operation {
  std::string_view name;
  std::string_view summary;
  std::string_view on;                           ///< the kinds of objects that it takes, such as "mesh"; empty: none
  std::unique_ptr<Call> (*call)();               ///< with the default options
  std::shared_ptr<const Object> (*no_result)();  ///< an empty result, which describes the parts of results
};

const std::vector<Operation>& operations();

/// The mesh of an object, which is a mesh or was made from one. Throws Error{invalid_option} for an object that the
/// operation does not take.
const MeshPtr& mesh_of(const Operation& operation, const Object& object);

/// Finds an operation by its name; null if there is none.
const Operation* find_operation(std::string_view name);

}  // namespace gvd
