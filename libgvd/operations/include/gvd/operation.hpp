#pragma once

#include <memory>
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
  /// Runs the operation once. Options become what they stand for.
  virtual std::shared_ptr<const Object> run(const MeshPtr& input, Observer& observer) = 0;
};

struct Operation {
  std::string_view name;
  std::string_view summary;
  std::unique_ptr<Call> (*call)();               ///< with the default options
  std::shared_ptr<const Object> (*no_result)();  ///< that describes the results
};

const std::vector<Operation>& operations();

/// Null where there is none of that name.
const Operation* find_operation(std::string_view name);

}  // namespace gvd
