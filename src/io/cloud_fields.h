// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl/PCLPointCloud2.h>

#include <cstdint>
#include <string>

namespace pcl_msf::io {

/** \brief Finds position and colour in the points of a cloud of any layout. */
class CloudFields {
public:
  /** \throws IoError when x, y or z is no float, or a colour not of four bytes \param
   * path for the error
   */
  CloudFields (const pcl::PCLPointCloud2& cloud, const std::string& path);

  /** \brief Position of the point at `bytes`; NaN three times unless all are finite. */
  void
  position (const unsigned char* bytes, float& x, float& y, float& z) const;

  /** \brief Colour as PCL packs it (alpha, red, green, blue), alpha 255; 0 without. */
  std::uint32_t
  color (const unsigned char* bytes) const;

private:
  pcl::PCLPointField x_, y_, z_;
  const pcl::PCLPointField* packed_{nullptr};    ///< rgb or rgba, 4 bytes
  const pcl::PCLPointField* intensity_{nullptr}; ///< any number
  double intensity_scale_{1.0};                  ///< to 0 .. 255
};

} // namespace pcl_msf::io
