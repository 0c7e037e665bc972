// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl_msf/errors.h>
#include <pcl_msf/synthetic/sequence_writer.h>
#include <pcl_msf/synthetic/synthetic_sequence.h>

/** Renders a small pair and writes it nowhere, so that io has to be linked, too. */
int
main ()
{
  pcl_msf::synthetic::SequenceOptions options;
  options.width = 32;
  options.height = 24;
  const auto sequence = pcl_msf::synthetic::synthesize (options);
  try {
    pcl_msf::synthetic::writeSequence (sequence, "/dev/null/no folder");
  }
  catch (const pcl_msf::IoError&) {
    return sequence.frames.size() == 2 ? 0 : 1;
  }
  return 1;
}
