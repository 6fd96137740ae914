#pragma once

#include <type_traits>

namespace fretval::fem {

#ifdef __x86_64__
template <class Work>
[[gnu::target("avx2"), gnu::flatten]] void with_avx2(const Work& work) {
  work(std::integral_constant<int, 4>());
}
#endif

/// Does some work in the widest registers of the processor among those that leave every operation as it is (mdr has
/// its own, as neither library knows the other). The work is told, as a constant, how many numbers one of them takes;
/// all of it has to be known to the compiler where this is called.
template <class Work>
void in_wide_registers(const Work& work) {
#ifdef __x86_64__
  static const bool has_avx2 = __builtin_cpu_supports("avx2") != 0;
  if (has_avx2) return with_avx2(work);
#endif
  work(std::integral_constant<int, 2>());
}

}  // namespace fretval::fem
