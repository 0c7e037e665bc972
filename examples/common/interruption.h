// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <stdexcept>

namespace pcl_msf::tool {

/** \brief Thrown between two stages after a signal that ends. */
class Interrupted : public std::runtime_error {
public:
  Interrupted();
};

/** \brief Has SIGINT, SIGTERM and SIGHUP noted in place of ending the process; a second
 * one ends it. A SIGHUP that is ignored (nohup) stays so. */
void
noteSignals ();

/** \brief Has a signal come? */
bool
interrupted ();

/** \brief Has a signal come? Then \throws Interrupted */
void
throwIfInterrupted ();

/** \brief Exit status for the signal that came, 128 + its number as shells do. */
int
interruptedStatus ();

} // namespace pcl_msf::tool
