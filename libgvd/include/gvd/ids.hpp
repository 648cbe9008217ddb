#pragma once

#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

namespace gvd {

/// A typed 0-based index, so that a generator can't index a face. -1 means "none".
template <class Tag>
class Id {
 public:
  constexpr Id() = default;
  /// `value` must fit into 32 bits; no mesh has more elements.
  template <std::integral Integer>
  constexpr explicit Id(Integer value) : value_(static_cast<std::int32_t>(value)) {}

  constexpr std::int32_t value() const { return value_; }
  constexpr std::size_t index() const { return static_cast<std::size_t>(value_); }
  constexpr bool valid() const { return value_ >= 0; }
  constexpr auto operator<=>(const Id&) const = default;

 private:
  std::int32_t value_ = -1;
};

using VertexId = Id<struct VertexTag>;
using EdgeId = Id<struct EdgeTag>;
using HalfedgeId = Id<struct HalfedgeTag>;
using FaceId = Id<struct FaceTag>;
using GeneratorId = Id<struct GeneratorTag>;
using BisectorId = Id<struct BisectorTag>;
using BranchPointId = Id<struct BranchPointTag>;

/// The ids from 0 to `count` - 1 in ascending order, for `for (FaceId f : mesh.faces())`.
template <class IdType>
class IdRange {
 public:
  class Iterator {
   public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = IdType;
    using difference_type = std::ptrdiff_t;
    using pointer = const IdType*;
    using reference = IdType;

    constexpr Iterator() = default;
    constexpr explicit Iterator(std::int32_t value) : value_(value) {}
    constexpr IdType operator*() const { return IdType(value_); }
    constexpr Iterator& operator++() {
      ++value_;
      return *this;
    }
    constexpr Iterator operator++(int) { return Iterator(value_++); }
    constexpr bool operator==(const Iterator&) const = default;

   private:
    std::int32_t value_ = 0;
  };

  /// `count` >= 0.
  template <std::integral Integer>
  constexpr explicit IdRange(Integer count) : count_(static_cast<std::int32_t>(count)) {}

  constexpr Iterator begin() const { return Iterator(0); }
  constexpr Iterator end() const { return Iterator(count_); }
  constexpr std::int32_t size() const { return count_; }

 private:
  std::int32_t count_;
};

/// A `std::vector` that only its own id type can index.
template <class IdType, class T>
class IdVector {
 public:
  IdVector() = default;
  explicit IdVector(std::size_t size, const T& value = T()) : values_(size, value) {}
  explicit IdVector(std::vector<T> values) : values_(std::move(values)) {}

  decltype(auto) operator[](IdType id) { return values_[id.index()]; }
  decltype(auto) operator[](IdType id) const { return values_[id.index()]; }
  std::size_t size() const { return values_.size(); }
  /// The number of elements as ids count them.
  std::int32_t count() const { return static_cast<std::int32_t>(values_.size()); }
  IdRange<IdType> ids() const { return IdRange<IdType>(values_.size()); }
  bool empty() const { return values_.empty(); }
  auto begin() { return values_.begin(); }
  auto end() { return values_.end(); }
  auto begin() const { return values_.begin(); }
  auto end() const { return values_.end(); }
  void reserve(std::size_t size) { values_.reserve(size); }
  void resize(std::size_t size, const T& value = T()) { values_.resize(size, value); }
  void assign(std::size_t size, const T& value) { values_.assign(size, value); }
  /// Appends and returns the id of the new element.
  IdType push_back(T value) {
    values_.push_back(std::move(value));
    return IdType(values_.size() - 1);
  }
  std::vector<T>& raw() { return values_; }
  const std::vector<T>& raw() const { return values_; }
  bool operator==(const IdVector&) const = default;

 private:
  std::vector<T> values_;
};

}  // namespace gvd
