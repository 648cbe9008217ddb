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

// What the C interface hands out, and the guard that lets no exception out.

namespace gvd::c {

/// A value that is made when somebody asks for it first, from any thread.
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

/// An object with the views of its parts. It holds what it refers to, so that handles may be released in any order.
struct gvd_object {
  /// What an object consists of, by its names.
  struct Views {
    std::map<std::string, std::function<gvd::ArrayView()>, std::less<>> arrays;
    struct Part {
      gvd::PartMaker make;  ///< gives null where this object has none
      std::string text;     ///< what it is
    };
    std::map<std::string, Part, std::less<>> parts;
  };

  explicit gvd_object(std::shared_ptr<const gvd::Object> made, gvd::Door of = gvd::Door::json);
  gvd_object(const gvd_object&) = delete;
  gvd_object& operator=(const gvd_object&) = delete;

  /// Throws Error{invalid_option} where this is no mesh.
  const gvd::MeshPtr& checked() const;
  const gvd::Mesh& mesh() const { return checked()->mesh; }
  /// Throws Error{invalid_option} where this is no diagram.
  const gvd::DiagramObject& diagram_object() const;
  const gvd::Diagram& diagram() const { return diagram_object().diagram(); }
  // The first call that asks for one of these makes it.
  const gvd::ClosestPointTree& closest() const;  ///< of a mesh
  const Views& views() const;
  const std::string& figures() const;  ///< JSON

  std::shared_ptr<const gvd::Object> object;
  gvd::Door door;                                    ///< of figures
  std::string told;                                  ///< further figures of a result, JSON; empty: none
  std::string repairs;                               ///< of a mesh, one line each
  std::optional<std::vector<gvd_point>> generators;  ///< of the vertices of a remesh

 private:
  gvd::c::Lazy<Views> views_;
  gvd::c::Lazy<std::string> figures_;
  gvd::c::Lazy<std::unique_ptr<gvd::ClosestPointTree>> tree_;
};

namespace gvd::c {

/// Keeps the message for gvd_last_error, and returns the status.
gvd_status fail(gvd_status status, const char* message, const char* code = "", std::int64_t element = -1) noexcept;
gvd_status fail(const Error& error, Door door = Door::json) noexcept;

inline gvd_status fail_memory() noexcept {
  return fail(GVD_OUT_OF_MEMORY, "out of memory; use a smaller mesh or fewer points");
}

/// The door of a run; JSON's where there is none.
Door door_of(const gvd_run* run) noexcept;

/// Does the work of a call; its exceptions become a status and a message.
template <class Work>
gvd_status guarded_for(const gvd_run* run, Work&& work) noexcept {
  try {
    work();
    return GVD_OK;
  } catch (const Error& error) {
    return fail(error, door_of(run));
  } catch (const std::bad_alloc&) {
    return fail_memory();
  } catch (const std::length_error&) {  // of a list that no memory holds
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

/// What a function without a status answers: `fallback` where an argument is NULL or an object of another kind.
template <class T, class Work>
T answered(T fallback, Work&& work) noexcept {
  guarded([&] { fallback = work(); });
  return fallback;
}

[[noreturn]] void refuse(const std::string& message);

/// The value behind an argument that must not be NULL.
template <class T>
T& given(T* argument, const char* name) {
  if (argument == nullptr) refuse(std::string(name) + " is NULL");
  return *argument;
}

/// The name of a file, which must not be empty.
inline std::string given_path(const char* path) {
  std::string name = &given(path, "path");
  if (name.empty()) refuse("path is empty; name a file");
  return name;
}

/// The result of an operation, with options as JSON. Throws what the operation throws.
std::unique_ptr<gvd_object> call(const char* operation, const gvd_object* on, const std::string& options,
                                 std::span<const ArrayView> arrays, const gvd_run* run);

/// What an operation tells, for the functions and the flag of a run.
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
