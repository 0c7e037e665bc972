// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl_msf/errors.h>
#include <pcl_msf/io/cloud_files.h>

/** Calls the io component, so that its dependencies have to be linked. */
int
main ()
{
  try {
    pcl_msf::io::readOrganizedCloud ("there is no such file.pcd");
  }
  catch (const pcl_msf::IoError&) {
    return 0;
  }
  return 1;
}
