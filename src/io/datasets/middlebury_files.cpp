// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/datasets/middlebury_files.h"

#include <opencv2/imgcodecs.hpp>

#include "core/base/number_text.h"
#include "io/base/input_file.h"
#include "io/datasets/file_lists.h"
#include "io/formats/decode_image.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/io/float_files.h>
#include <pcl_msf/io/images.h>

#include <cmath>
#include <limits>
#include <map>
#include <sstream>

namespace pcl_msf::io {

namespace {

/** The stem's file in one of the formats that the data sets came in; .png when none. */
std::string
imageNamed (const std::string& folder, const std::string& stem)
{
  for (const char* extension : {".png", ".ppm", ".pgm"})
    if (isFile (inside (folder, stem + extension)))
      return inside (folder, stem + extension);
  return inside (folder, stem + ".png");
}

/** The lines "name=value" of a calib.txt. */
class Calibration {
public:
  explicit Calibration (const std::string& path) : file_ (path)
  {
    std::istringstream lines (file_.text());
    for (std::string line; std::getline (lines, line);) {
      const std::size_t equals = line.find ('=');
      if (equals != std::string::npos)
        values_[line.substr (0, equals)] = line.substr (equals + 1);
    }
  }

  /** The numbers of a value, whatever brackets and semicolons are around them. */
  std::vector<double>
  numbers (const std::string& name, std::size_t count) const
  {
    const auto value = values_.find (name);
    if (value == values_.end())
      file_.fail (name, "missing; give the file of the data set");
    std::string text = value->second;
    for (char& c : text)
      if (c == '[' || c == ']' || c == ';')
        c = ' ';
    std::istringstream words (text);
    std::vector<double> result;
    for (std::string word; words >> word;) {
      double number = 0.0;
      if (!parseNumber (word, number) || !std::isfinite (number))
        file_.fail (name,
                    "'" + word.substr (0, 32) +
                        "' is no finite number; give the file of the data set");
      result.push_back (number);
    }
    if (result.size() != count)
      file_.fail (name,
                  std::to_string (result.size()) + " numbers where " +
                      std::to_string (count) +
                      " are needed; give the file of the data set");
    return result;
  }

  PinholeCamera
  camera (const std::string& name) const
  {
    const std::vector<double> k = numbers (name, 9);
    if (!(k[0] > 0.0) || !(k[4] > 0.0))
      file_.fail (name,
                  "no camera, for its focal length is " + generalText (k[0]) + ", " +
                      generalText (k[4]) + "; give the file of the data set");
    return {k[0], k[4], k[2], k[5]};
  }

private:
  InputFile file_;
  std::map<std::string, std::string> values_;
};

MiddleburyPair
findCalibrated (const std::string& folder)
{
  const Calibration calibration (inside (folder, "calib.txt"));
  MiddleburyPair pair;
  pair.color = {imageNamed (folder, "im0"), imageNamed (folder, "im1")};
  pair.disparity = {inside (folder, "disp0.pfm"), inside (folder, "disp1.pfm")};
  pair.camera = {calibration.camera ("cam0"), calibration.camera ("cam1")};
  pair.baseline = calibration.numbers ("baseline", 1)[0] / 1000.0;
  pair.offset = calibration.numbers ("doffs", 1)[0];
  return pair;
}

MiddleburyPair
findUncalibrated (const std::string& folder)
{
  MiddleburyPair pair;
  pair.color = {imageNamed (folder, "im2"), imageNamed (folder, "im6")};
  pair.disparity = {imageNamed (folder, "disp2"), imageNamed (folder, "disp6")};
  const cv::Size size = readColor (pair.color[0]).size();
  const double focal = size.width * 10.0 / 9.0;
  pair.camera.fill ({focal, focal, 0.5 * (size.width - 1), 0.5 * (size.height - 1)});
  pair.disparity_scale = size.width <= 600 ? 4.0 : size.width <= 1200 ? 2.0 : 1.0;
  return pair;
}

} // namespace

bool
isMiddlebury (const std::string& folder)
{
  const bool calibrated =
      isFile (inside (folder, "calib.txt")) && isFile (imageNamed (folder, "im0"));
  return calibrated ||
         (isFile (imageNamed (folder, "im2")) && isFile (imageNamed (folder, "disp2")));
}

MiddleburyPair
findMiddlebury (const std::string& folder)
{
  return isFile (inside (folder, "calib.txt")) ? findCalibrated (folder)
                                               : findUncalibrated (folder);
}

cv::Mat
readMiddleburyDisparity (const MiddleburyPair& pair, std::size_t view)
{
  const std::string& path = pair.disparity.at (view);
  cv::Mat disparity;
  if (pair.disparity_scale) {
    const cv::Mat grey = decodeImage (path, cv::IMREAD_GRAYSCALE, "disparity");
    grey.convertTo (disparity, CV_32F, 1.0 / *pair.disparity_scale);
  }
  else {
    disparity = readPfm (path);
    if (disparity.type() != CV_32FC1)
      throw IoError (path +
                     ": disparity: three channels (PF), not one (Pf); give the file of "
                     "the data set");
  }
  for (int row = 0; row < disparity.rows; ++row)
    for (int col = 0; col < disparity.cols; ++col) {
      auto& d = disparity.at<float> (row, col);
      if (!std::isfinite (d) || !(d > 0.0F))
        d = std::numeric_limits<float>::quiet_NaN();
    }
  return disparity;
}

} // namespace pcl_msf::io
