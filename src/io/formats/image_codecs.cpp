// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/formats/image_codecs.h"

#include <opencv2/imgcodecs.hpp>

#include "core/base/lazy_library.h"
#ifdef PCL_MSF_HAS_PNG
#include "io/formats/png_image.h"
#endif

namespace pcl_msf::io {

namespace {

using Bytes = std::vector<unsigned char>;

cv::Mat
decodeByOpenCv (const Bytes& bytes, int flags)
{
#ifdef PCL_MSF_IMGCODECS_FILES
  static auto* const decode = loadFunction<cv::Mat (cv::InputArray, int)> (
      {PCL_MSF_IMGCODECS_FILES}, "_ZN2cv8imdecodeERKNS_11_InputArrayEi");
  return decode (bytes, flags);
#else
  return cv::imdecode (bytes, flags);
#endif
}

bool
encodeByOpenCv (const std::string& extension, const cv::Mat& image, Bytes& bytes)
{
#ifdef PCL_MSF_IMGCODECS_FILES
  using Encode =
      bool (const cv::String&, cv::InputArray, Bytes&, const std::vector<int>&);
  static auto* const encode = loadFunction<Encode> (
      {PCL_MSF_IMGCODECS_FILES},
      "_ZN2cv8imencodeERKNSt7__cxx1112basic_stringIcSt11char_traitsIcESaIcEEERKNS_"
      "11_InputArrayERSt6vectorIhSaIhEERKSB_IiSaIiEE");
  return encode (extension, image, bytes, {});
#else
  return cv::imencode (extension, image, bytes);
#endif
}

} // namespace

cv::Mat
decodeBytes (const Bytes& bytes, int flags)
{
#ifdef PCL_MSF_HAS_PNG
  cv::Mat image = decodePng (bytes, flags);
  if (!image.empty())
    return image;
#endif
  return decodeByOpenCv (bytes, flags | cv::IMREAD_IGNORE_ORIENTATION);
}

Bytes
encodeBytes (const std::string& extension, const cv::Mat& image)
{
  Bytes bytes;
#ifdef PCL_MSF_HAS_PNG
  if (extension == ".png")
    bytes = encodePng (image);
  if (!bytes.empty())
    return bytes;
#endif
  if (image.empty() || !encodeByOpenCv (extension, image, bytes))
    bytes.clear();
  return bytes;
}

} // namespace pcl_msf::io
