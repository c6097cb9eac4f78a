// SPDX-License-Identifier: BSD-3-Clause
#ifndef kalos_estimator_Multiversion_h
#define kalos_estimator_Multiversion_h

// Functions compiled for AVX-512, AVX2 and SSE2, chosen at run time; not where the compiler or a sanitizer forbids it.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define KALOS_MULTIVERSION __attribute__((target_clones("arch=skylake-avx512", "arch=haswell", "default")))
#else
#define KALOS_MULTIVERSION
#endif

#endif
