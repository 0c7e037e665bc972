// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "evaluation/check_images.h"

#include <pcl_msf/errors.h>

#include <string>

namespace pcl_msf::evaluation {

void
requireImage (const char* name, const cv::Mat& image, int type, const cv::Size& size)
{
  if (image.type() != type)
    throw InvalidInput (std::string (name) + " must be " + cv::typeToString (type) +
                        ", is " + cv::typeToString (image.type()));
  if (image.size() != size)
    throw InvalidInput (std::string (name) + " must be " + std::to_string (size.width) +
                        "x" + std::to_string (size.height) + ", is " +
                        std::to_string (image.cols) + "x" +
                        std::to_string (image.rows));
}

} // namespace pcl_msf::evaluation
