#pragma once

#include <malloc.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>

// Operators new and delete of a program that counts its heap, in place of those of the standard library. One source of
// the program includes this file, and defines the three functions.
namespace gvd::heap {

/// `alignment` is 0 for that of malloc. Throws std::bad_alloc.
void* allocate(std::size_t size, std::size_t alignment);
/// Null where there is no memory.
void* try_allocate(std::size_t size) noexcept;
void release(void* block) noexcept;  // null too

/// A block as malloc gives it. Null where there is no memory.
inline void* allocate_block(std::size_t size, std::size_t alignment) noexcept {
  const std::size_t some = size == 0 ? 1 : size;
  if (alignment == 0) return std::malloc(some);
  return std::aligned_alloc(alignment, (some + alignment - 1) / alignment * alignment);
}

/// Bytes that a block has for its use.
inline std::int64_t usable_size(void* block) noexcept { return static_cast<std::int64_t>(malloc_usable_size(block)); }

}  // namespace gvd::heap

// In the standard library some forms call the others, but not in that of sanitizers.
void* operator new(std::size_t size) { return gvd::heap::allocate(size, 0); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return gvd::heap::try_allocate(size); }
void* operator new[](std::size_t size) { return gvd::heap::allocate(size, 0); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return gvd::heap::try_allocate(size); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return gvd::heap::allocate(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* block) noexcept { gvd::heap::release(block); }
void operator delete(void* block, std::size_t) noexcept { gvd::heap::release(block); }
void operator delete(void* block, const std::nothrow_t&) noexcept { gvd::heap::release(block); }
void operator delete[](void* block) noexcept { gvd::heap::release(block); }
void operator delete[](void* block, std::size_t) noexcept { gvd::heap::release(block); }
void operator delete[](void* block, const std::nothrow_t&) noexcept { gvd::heap::release(block); }
void operator delete(void* block, std::align_val_t) noexcept { gvd::heap::release(block); }
void operator delete(void* block, std::size_t, std::align_val_t) noexcept { gvd::heap::release(block); }
