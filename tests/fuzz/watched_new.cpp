#include "tests/fuzz/watched_new.h"

#include <algorithm>
#include <cstdlib>
#include <new>

namespace fascia::test {

std::size_t largest_allocation = 0;

}  // namespace fascia::test

void* operator new(std::size_t size) {
  fascia::test::largest_allocation = std::max(fascia::test::largest_allocation, size);
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  fascia::test::largest_allocation = std::max(fascia::test::largest_allocation, size);
  return std::malloc(size == 0 ? 1 : size);
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
