// In a file of its own: inlined into a test, the two halves of a replaced new and delete make GCC warn of a mismatch.

#include "counted_allocations.hpp"

#include <cstdlib>
#include <new>

namespace {
long allocations = 0;
}  // namespace

long countedAllocations() { return allocations; }

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
