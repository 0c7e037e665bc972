// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl_msf/errors.h>
#include <pcl_msf/synthetic/sequence_writer.h>
#include <pcl_msf/synthetic/synthetic_sequence.h>

/** Renders a small pair and writes it nowhere, so that io has to be linked, too. */
int
main ()
{
  pcl_msf::SequenceOptions options;
  options.width = 32;
  options.height = 24;
  const auto sequence = pcl_msf::synthesize (options);
  try {
    pcl_msf::writeSequence (sequence, "/dev/null/no folder");
  }
  catch (const pcl_msf::IoError&) {
    return sequence.frames.size() == 2 ? 0 : 1;
  }
  return 1;
}
