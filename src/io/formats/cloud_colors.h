// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl/PCLPointCloud2.h>

#include "io/formats/cloud_fields.h"
#include <pcl_msf/io/rgbd_images.h>

namespace pcl_msf::io {

/** \brief Takes the colours of an organized cloud into `color`, CV_8UC3, and
 * `raw_color`; without any both stay empty and `note` says so. */
void
takeColors (const pcl::PCLPointCloud2& cloud,
            const CloudFields& fields,
            RgbdImages& images);

} // namespace pcl_msf::io
