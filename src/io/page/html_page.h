// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

namespace pcl_msf::io {

/** \brief Style sheet of a page. */
extern const char* const kPageStyle;

/** \brief Script of a page: sliders, flicker, sorting, bar plots. */
extern const char* const kPageScript;

} // namespace pcl_msf::io
