// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl_msf/evaluation/flow_errors.h>

int
main ()
{
  const cv::Mat truth (2, 3, CV_32FC2, cv::Scalar (1.0, 0.0));
  const cv::Mat rest (2, 3, CV_32FC2, cv::Scalar (0.0, 0.0));
  const cv::Mat mask (2, 3, CV_8UC1, cv::Scalar (255));
  return pcl_msf::evaluation::flowErrors (rest, truth, mask).epe == 1.0 ? 0 : 1;
}
