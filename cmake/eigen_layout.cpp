// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <Eigen/Core>

/* Compiled with the project's own flags, never run: what Eigen decides under them
 * stands in the program as text, as in CMake's own look at a compiler. */

#define DIGITS(n) '0' + (n) / 100 % 10, '0' + (n) / 10 % 10, '0' + (n) % 10
#define KEY(k) 'p', 'c', 'l', '_', 'm', 's', 'f', ' ', k, '='

#if EIGEN_DEFAULT_ALIGN_BYTES == 0 || EIGEN_MALLOC_ALREADY_ALIGNED
#define PLAIN_MALLOC 1
#else
#define PLAIN_MALLOC 0
#endif

const char static_align[] = {KEY ('S'), DIGITS (EIGEN_MAX_STATIC_ALIGN_BYTES), 0};
const char heap_align[] = {KEY ('H'), DIGITS (EIGEN_DEFAULT_ALIGN_BYTES), 0};
const char plain_malloc[] = {KEY ('M'), DIGITS (PLAIN_MALLOC), 0};

int
main (int argc, char**)
{
  return static_align[argc] + heap_align[argc] + plain_malloc[argc];
}
