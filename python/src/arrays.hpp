#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "gvd/ids.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"

// Arrays of the library as NumPy arrays. A view shares the memory of its owner, keeps it alive, and can't be written.
namespace gvd::python {

namespace py = pybind11;

/// An argument: NumPy converts other types, strides and lists.
template <class T>
using Array = py::array_t<T, py::array::c_style | py::array::forcecast>;

/// The numbers of one element: how many, and of which type. Ids are 32-bit integers, -1 for none.
template <class Value>
struct Numbers {
  using Type = Value;
  static constexpr py::ssize_t count = 0;
};
template <class Tag>
struct Numbers<Id<Tag>> {
  using Type = std::int32_t;
  static constexpr py::ssize_t count = 0;
};
template <int N>
struct Numbers<Eigen::Matrix<double, N, 1>> {
  using Type = double;
  static constexpr py::ssize_t count = N;
};
template <class Value, std::size_t N>
struct Numbers<std::array<Value, N>> {
  using Type = typename Numbers<Value>::Type;
  static constexpr py::ssize_t count = N;
};
static_assert(sizeof(VertexId) == sizeof(std::int32_t) && sizeof(Vec3) == 3 * sizeof(double));

/// A view of `count` elements, each `stride` bytes after the one before: members of a vector of structs.
template <class Value>
py::array view_members(const Value* first, std::size_t count, std::size_t stride, const py::handle& owner) {
  using Type = typename Numbers<Value>::Type;
  std::vector<py::ssize_t> shape{py::ssize_t(count)}, strides{py::ssize_t(stride)};
  if (constexpr py::ssize_t columns = Numbers<Value>::count; columns > 0) {
    shape.push_back(columns);
    strides.push_back(sizeof(Type));
  }
  const py::array_t<Type> array(shape, strides, reinterpret_cast<const Type*>(first), owner);
  array.attr("flags").attr("writeable") = false;
  return array;
}

/// A view of a vector.
template <class Value>
py::array view(const std::vector<Value>& values, const py::handle& owner) {
  return view_members(values.data(), values.size(), sizeof(Value), owner);
}
template <class IdType, class Value>
py::array view(const IdVector<IdType, Value>& values, const py::handle& owner) {
  return view(values.raw(), owner);
}

/// A view of one member of every struct of a vector.
template <class Struct, class Value>
py::array view(const std::vector<Struct>& structs, Value Struct::*member, const py::handle& owner) {
  const Value* const first = structs.empty() ? nullptr : &(structs.front().*member);
  return view_members(first, structs.size(), sizeof(Struct), owner);
}

/// The vector that `view` has made an array of.
template <class Value>
std::vector<Value> to_vector(const py::handle& viewed) {
  const auto numbers = viewed.cast<Array<typename Numbers<Value>::Type>>();
  std::vector<Value> values(numbers.shape(0));
  std::copy_n(numbers.data(), numbers.size(), reinterpret_cast<typename Numbers<Value>::Type*>(values.data()));
  return values;
}

/// An array that takes over a vector.
template <class Vector>
py::array take(Vector&& values) {
  static_assert(std::is_rvalue_reference_v<Vector&&>);
  auto owned = std::make_unique<Vector>(std::move(values));
  const Vector& kept = *owned;
  const py::capsule owner(owned.release(), [](void* p) { delete static_cast<Vector*>(p); });
  return view(kept, owner);
}

/// Faces (n) and barycentric coordinates (n, 3) of points.
inline py::tuple view_points(const std::vector<SurfacePoint>& points, const py::handle& owner) {
  return py::make_tuple(view(points, &SurfacePoint::face, owner), view(points, &SurfacePoint::bary, owner));
}

}  // namespace gvd::python
