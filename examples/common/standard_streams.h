// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

namespace pcl_msf::tool {

/** \brief Before anything is opened or printed: stdin, stdout and stderr that are
 * closed become /dev/null, so that no file takes their place and gets what is printed;
 * a reader of stdout who goes away (`| head -1`) does not end the process. */
void
keepStandardStreams ();

/** \brief Is what is printed from now on lost? */
bool
standardOutputIsLost ();

/** \brief After the work: everything printed is where it should be, or its reader has
 * gone, who wants no more. \throws IoError when it could not be written otherwise, as
 * to a full disk */
void
finishStandardOutput ();

} // namespace pcl_msf::tool
