#pragma once
/// The only file that knows threads. Results never depend on how many there are: an index owns what it writes, and sums
/// are taken in the order of the indices afterwards.

#include <omp.h>

#include <cstddef>

namespace talus {

inline int thread_count() {
  return omp_get_max_threads();
}
inline void set_thread_count(int n) {
  omp_set_num_threads(n);
}
/// Number of the calling thread, 0 ... thread_count() - 1: for scratch memory.
inline int thread_number() {
  return omp_get_thread_num();
}

/// Calls f(i) for i = 0 ... n - 1 on all threads, in any order. f must not throw.
template <class F>
void for_each_index(std::ptrdiff_t n, F const& f) {
  if (n <= 1) {  // to wake the others costs more
    if (n == 1) f(std::ptrdiff_t{0});
    return;
  }
#pragma omp parallel for schedule(dynamic, 2)
  for (std::ptrdiff_t i = 0; i < n; ++i) f(i);
}

}  // namespace talus
