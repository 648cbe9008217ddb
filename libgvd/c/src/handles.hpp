#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gvd/closest_point.hpp"
#include "gvd/error.hpp"
#include "gvd/gvd.h"
#include "gvd/mesh_objects.hpp"
#include "gvd/object.hpp"
#include "gvd/observer.hpp"
#include "gvd/operation_json.hpp"
#include "gvd/surface_point.hpp"

// The handles that the C interface returns, and the guard that lets no exception escape.

namespace gvd::c {

/// A value that is made on first use, from any thread.
template <class T>
class Lazy {
 public:
  template <class Make>
  const T& get(const Make& make) const {
    std::call_once(made_, [&] { value_ = make(); });
    return value_;
  }

 private:
  mutable std::once_flag made_;
  mutable T value_{};
};

}  // namespace gvd::c

/// An object with the views of its parts. It keeps everything alive to which it refers, so that handles may be released
/// in any order.
struct gvd_object {
  /// The parts of an object, by name.
  struct Views {
    std::map<std::string, std::function<gvd::ArrayView()>, std::less<>> arrays;
    struct Part {
      gvd::PartMaker make;  ///< returns null if this object does not have the part
      std::string text;     ///< a description
    };
    std::map<std::string, Part, std::less<>> parts;
  };

  explicit gvd_object(std::shared_ptr<const gvd::Object> made, gvd::Door of = gvd::Door::json);
  gvd_object(const gvd_object&) = delete;
  gvd_object& operator=(const gvd_object&) = delete;

  /// The mesh. Throws Error{invalid_option} if the object is no mesh.
  const gvd::MeshPtr& checked() const;
  const gvd::Mesh& mesh() const { return checked()->mesh; }
  /// The diagram. Throws Error{invalid_option} if the object is no diagram.
  const gvd::DiagramObject& diagram_object() const;
  const gvd::Diagram& diagram() const { return diagram_object().diagram(); }
  // Each of these is made on first use.
  const gvd::ClosestPointTree& closest() const;  ///< only for a mesh
  const Views& views() const;
  const std::string& figures() const;  ///< JSON

  std::shared_ptr<const gvd::Object> object;
  gvd::Door door;                                    ///< whose spelling the figures use
  std::string told;                                  ///< further figures of a result, as JSON; empty for none
  std::string repairs;                               ///< for a mesh, one line each
  std::optional<std::vector<gvd_point>> generators;  ///< for a remesh, the generator of each vertex

 private:
  gvd::c::Lazy<Views> views_;
  gvd::c::Lazy<std::string> figures_;
  gvd::c::Lazy<std::unique_ptr<gvd::ClosestPointTree>> tree_;
};

namespace gvd::c {

/// Stores the message for gvd_last_error, and returns the status.
gvd_status fail(gvd_status status, const char* message, const char* code = "", std::int64_t element = -1) noexcept;
gvd_status fail(const Error& error, Door door = Door::json) noexcept;

inline gvd_status fail_memory() noexcept {
  return fail(GVD_OUT_OF_MEMORY, "out of memory; use a smaller mesh or fewer points");
}

/// The door of a run, or Door::json without a run.
Door door_of(const gvd_run* run) noexcept;

/// Does the work of a call, and turns exceptions into a status and a message.
template <class Work>
gvd_status guarded_for(const gvd_run* run, Work&& work) noexcept {
  try {
    work();
    return GVD_OK;
  } catch (const Error& error) {
    return fail(error, door_of(run));
  } catch (const std::bad_alloc&) {
    return fail_memory();
  } catch (const std::length_error&) {  // thrown for a list too large for memory
    return fail_memory();
  } catch (const std::exception& error) {
    return fail(GVD_INTERNAL_ERROR, error.what());
  } catch (...) {
    return fail(GVD_INTERNAL_ERROR, "unknown exception");
  }
}

template <class Work>
gvd_status guarded(Work&& work) noexcept {
  return guarded_for(nullptr, std::forward<Work>(work));
}

/// The result of a function without a status: `fallback` if an argument is NULL or an object of another kind.
template <class T, class Work>
T answered(T fallback, Work&& work) noexcept {
  guarded([&] { fallback = work(); });
  return fallback;
}

[[noreturn]] void refuse(const std::string& message);

/// Dereferences an argument that must not be NULL.
template <class T>
T& given(T* argument, const char* name) {
  if (argument == nullptr) refuse(std::string(name) + " is NULL");
  return *argument;
}

/// Checks the name of a file, which must not be empty.
inline std::string given_path(const char* path) {
  std::string name = &given(path, "path");
  if (name.empty()) refuse("path is empty; name a file");
  return name;
}

/// Calls an operation with options as JSON, and returns its result. Throws what the operation throws.
std::unique_ptr<gvd_object> call(const char* operation, const gvd_object* on, const std::string& options,
                                 std::span<const ArrayView> arrays, const gvd_run* run);

/// Passes the messages of an operation to the functions of a gvd_run, and checks its flags.
class CallObserver : public Observer {
 public:
  explicit CallObserver(const gvd_run* run);
  bool progress(std::string_view step, double fraction) override;
  void enter(std::string_view step) override;
  void note(const std::string& text) override;
  void warn(const std::string& text) override;
  void iterated(std::int64_t iterations, double energy, const std::vector<SurfacePoint>& generators) override;
  const std::vector<std::string>& notes() const { return notes_; }
  const std::vector<std::string>& warnings() const { return warnings_; }
  Door door() const { return door_of(&run_); }

 private:
  bool is_cancelled() const;

  gvd_run run_{};
  std::vector<std::string> notes_, warnings_;
};

}  // namespace gvd::c
