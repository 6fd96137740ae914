#pragma once

namespace fretval::mdr {

#ifdef __x86_64__
template <class Work>
[[gnu::target("avx2"), gnu::flatten]] void with_avx2(const Work& work) {
  work();
}
#endif

/// Does some work in the widest registers of the processor among those that leave every operation as it is: its loops
/// take four numbers at a time instead of two, and the results are the same to the last bit. All of the work has to be
/// known to the compiler where this is called.
template <class Work>
void in_wide_registers(const Work& work) {
#ifdef __x86_64__
  static const bool has_avx2 = __builtin_cpu_supports("avx2") != 0;
  if (has_avx2) return with_avx2(work);
#endif
  work();
}

}  // namespace fretval::mdr
