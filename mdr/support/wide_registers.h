#pragma once

namespace fretval::mdr {

#ifdef __x86_64__
template <class Work>
[[gnu::target("avx2"), gnu::flatten]] void with_avx2(const Work& work) {
  work();
}

#ifdef __clang__  // takes them as wide as they are
#define FRETVAL_AVX512 "avx512f,avx512vl,avx512dq"
#else
#define FRETVAL_AVX512 "avx512f,avx512vl,avx512dq,prefer-vector-width=512"
#endif
template <class Work>
[[gnu::target(FRETVAL_AVX512), gnu::flatten]] void with_avx512(const Work& work) {
  work();
}
#undef FRETVAL_AVX512
#endif

/// Does some work in the widest registers of the processor: its loops take four or eight numbers at a time instead of
/// two, and the results are the same to the last bit (the build leaves every operation as it is, see CMakeLists.txt).
/// All of the work has to be known to the compiler where this is called.
template <class Work>
void in_wide_registers(const Work& work) {
#ifdef __x86_64__
  static const bool has_avx512 =
      __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq");
  static const bool has_avx2 = __builtin_cpu_supports("avx2") != 0;
  if (has_avx512) return with_avx512(work);
  if (has_avx2) return with_avx2(work);
#endif
  work();
}

}  // namespace fretval::mdr
