// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SimdClones.h
 * @brief Versions of a loop for several processors, of which the program takes one when it is
 * loaded.
 *
 * RECON_CLONES_EXACT   wide registers, no fused operations: the same bits on every processor
 * RECON_CLONES_FUSED   may fuse a product and a sum: the last bits depend on the processor, never
 *                      on the number of threads
 * RECON_CLONES_WIDEST  the same up to the widest registers; compiled with -ffp-contract=off, exact
 *
 * Other processors and compilers, and the sanitizers, which cannot follow the choice, make
 * the plain version alone. For .cxx files only.
 */
#ifndef recon_SimdClones_h
#define recon_SimdClones_h

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
  !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define RECON_CLONES_EXACT __attribute__((target_clones("avx2", "default")))
#define RECON_CLONES_FUSED __attribute__((target_clones("arch=haswell", "default")))
#else
#define RECON_CLONES_EXACT
#define RECON_CLONES_FUSED
#endif

// GCC before 12 does not know the levels by name.
#if defined(__x86_64__) && defined(__GNUC__) && __GNUC__ >= 12 && !defined(__clang__) && \
  !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define RECON_CLONES_WIDEST \
  __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define RECON_CLONES_WIDEST
#endif

#endif
