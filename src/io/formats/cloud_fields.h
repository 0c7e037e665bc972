// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl/PCLPointCloud2.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace pcl_msf::io {

/** \brief One number of every point: where it is in a point's bytes, and its type. */
struct CloudChannel {
  std::size_t offset{0};
  int type{0}; ///< pcl::PCLPointField's

  /** \brief Its value in the point at `bytes`; NaN for types that are no numbers. */
  double
  value (const unsigned char* bytes) const;
};

/** \brief Finds position and colour in the points of a cloud of any layout. */
class CloudFields {
public:
  /** \param path for the error \throws IoError when x, y or z is no float, or a colour
   * not of four bytes */
  CloudFields (const pcl::PCLPointCloud2& cloud, const std::string& path);

  /** \brief Position of the point at `bytes`; NaN three times unless all are finite. */
  void
  position (const unsigned char* bytes, float& x, float& y, float& z) const;

  /** \brief Where PCL packs red, green and blue into four bytes: rgb or rgba. */
  const std::optional<CloudChannel>&
  packedColor () const
  {
    return packed_;
  }

  /** \brief Blue, green and red, each a number: three fields, or one of three or four
   * numbers; or the intensity alone; or nothing. */
  const std::vector<CloudChannel>&
  colorNumbers () const
  {
    return numbers_;
  }

private:
  std::array<CloudChannel, 3> position_;
  std::optional<CloudChannel> packed_;
  std::vector<CloudChannel> numbers_;
};

} // namespace pcl_msf::io
