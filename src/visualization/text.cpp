// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "visualization/text.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include <algorithm>
#include <cmath>

namespace pcl_msf::visualization {

namespace {

constexpr int kDpi = 72;            ///< one point is one pixel
constexpr double kFontShare = 0.74; ///< font size in a line's height
constexpr double kBaseShare = 0.76; ///< base line below the upper edge

/** The rendered letters, upright, and where their base line is in them. */
cv::Mat
letters (const std::string& text, int font_size, bool bold, int& base)
{
  auto property = vtkSmartPointer<vtkTextProperty>::New();
  property->SetFontFamilyToArial();
  property->SetFontSize (font_size);
  property->SetBold (bold);
  property->SetColor (1.0, 1.0, 1.0);
  vtkTextRenderer* renderer = vtkTextRenderer::GetInstance();
  auto image = vtkSmartPointer<vtkImageData>::New();
  const vtkStdString words (text);
  int box[4] = {0, 0, 0, 0};
  int size[2] = {0, 0};
  if (renderer == nullptr || !renderer->GetBoundingBox (property, words, box, kDpi) ||
      !renderer->RenderString (property, words, image, size, kDpi))
    return {};
  const int* whole = image->GetDimensions();
  const cv::Mat rgba (
      whole[1], whole[0], CV_8UC4, image->GetScalarPointer()); // row 0 is the lowest
  cv::Mat mask;
  cv::extractChannel (rgba, mask, 3);
  mask = mask (
      cv::Rect (0, 0, std::min (size[0], whole[0]), std::min (size[1], whole[1])));
  cv::flip (mask, mask, 0);
  base = mask.rows + box[2];
  return mask;
}

} // namespace

cv::Mat
textMask (const std::string& text, int height, bool bold)
{
  int base = 0;
  const int font_size = std::max (1, cvRound (kFontShare * height));
  const cv::Mat glyphs =
      text.empty() ? cv::Mat() : letters (text, font_size, bold, base);
  cv::Mat mask = cv::Mat::zeros (height, std::max (1, glyphs.cols), CV_8UC1);
  if (glyphs.empty())
    return mask;
  const int top = cvRound (kBaseShare * height) - base;
  const cv::Rect place (0, top, glyphs.cols, glyphs.rows);
  const cv::Rect inside = place & cv::Rect (0, 0, mask.cols, mask.rows);
  if (!inside.empty())
    glyphs (inside - place.tl()).copyTo (mask (inside));
  return mask;
}

int
drawLine (cv::Mat& picture,
          const std::string& text,
          const cv::Point& corner,
          int height,
          const cv::Scalar& color,
          bool bold)
{
  const cv::Mat mask = textMask (text, height, bold);
  const cv::Rect place (corner, mask.size());
  const cv::Rect inside = place & cv::Rect (0, 0, picture.cols, picture.rows);
  for (int row = inside.y; row < inside.br().y; ++row)
    for (int col = inside.x; col < inside.br().x; ++col) {
      const double share =
          mask.at<unsigned char> (row - corner.y, col - corner.x) / 255.0;
      auto& pixel = picture.at<cv::Vec3b> (row, col);
      for (int c = 0; c < 3; ++c)
        pixel[c] = cv::saturate_cast<unsigned char> ((1.0 - share) * pixel[c] +
                                                     share * color[c]);
    }
  return mask.cols;
}

} // namespace pcl_msf::visualization
