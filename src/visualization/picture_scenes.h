// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/visualization/result_scenes.h>

namespace pcl_msf::visualization {

// One scene each, see PictureKind. \throws InvalidInput as resultScene.

Scene
segmentScene (const ResultClouds& result);

Scene
motionScene (const ResultClouds& result);

Scene
occlusionScene (const ResultClouds& result);

Scene
arrowScene (const ResultClouds& result, const SceneOptions& options);

Scene
residualScene (const ResultClouds& result, const SceneOptions& options);

Scene
depthResidualScene (const ResultClouds& result, const SceneOptions& options);

} // namespace pcl_msf::visualization
