#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "gvd/operation.hpp"
#include "gvd/operation_json.hpp"
#include "operations/recorder.hpp"

namespace gvd::test {

using ObjectPtr = std::shared_ptr<const Object>;

/// The result of an operation with options as JSON.
inline ObjectPtr call(const char* operation, const ObjectPtr& on, const std::string& options, Observer& observer) {
  const Operation& found = *find_operation(operation);
  const auto made = found.call();
  OptionList list;
  made->describe(list);
  read_json_options(list, *mesh_of(found, *on), options, {});
  return made->run(on, observer);
}

inline ObjectPtr call(const char* operation, const ObjectPtr& on, const std::string& options) {
  Recorder told;
  return call(operation, on, options, told);
}

/// The part of a result of that name; null where there is none.
inline ObjectPtr part_of(const ObjectPtr& object, std::string_view name) {
  struct Reader : ObjectVisitor {
    void part(const Meaning& meaning, std::string_view, const PartMaker& make) override {
      if (meaning.name == wanted) found = make();
    }
    std::string_view wanted;
    ObjectPtr found;
  } reader;
  reader.wanted = name;
  object->visit(reader);
  return reader.found;
}

/// What a diagram object holds.
inline const Diagram& diagram_of(const ObjectPtr& object) {
  return dynamic_cast<const DiagramObject&>(*object).diagram();
}

}  // namespace gvd::test
