#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "gvd/mesh_objects.hpp"
#include "gvd/object.hpp"
#include "gvd/observer.hpp"
#include "gvd/option_list.hpp"

// The operations of the library, as doors see them: options in, an object out.
namespace gvd {

/// One call of an operation, with its options.
class Call {
 public:
  virtual ~Call() = default;
  /// Describes the options, which this holds.
  virtual void describe(OptionList& list) = 0;
  /// Takes arrays that no option refers to. They must stay until `run` has returned.
  virtual void take(std::span<const ArrayView> /*arrays*/) {}
  /// Runs the operation once, on an object of the kind that it takes. Options become what they stand for.
  /// Throws Error{invalid_option} for an object of another kind, and what the operation throws.
  virtual std::shared_ptr<const Object> run(const std::shared_ptr<const Object>& on, Observer& observer) = 0;
};

struct Operation {
  std::string_view name;
  std::string_view summary;
  std::string_view on;                           ///< the kinds of objects that it takes, such as "mesh"; empty: none
  std::unique_ptr<Call> (*call)();               ///< with the default options
  std::shared_ptr<const Object> (*no_result)();  ///< that describes the results
};

const std::vector<Operation>& operations();

/// The mesh that an object is, or is of. Throws Error{invalid_option} for one that the operation does not take.
const MeshPtr& mesh_of(const Operation& operation, const Object& object);

/// Null where there is none of that name.
const Operation* find_operation(std::string_view name);

}  // namespace gvd
