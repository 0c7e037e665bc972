// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl_msf/registration_settings.h>

namespace pcl_msf {

void
RegistrationSettings::setSourceNormals (const NormalCloudConstPtr& normals)
{
  if (!normals || !normals->points.empty())
    normals_ = normals;
  else
    printError ("setSourceNormals",
                "there are no normals: give one per point of the source, or a null "
                "pointer to have them computed");
}

void
RegistrationSettings::setSegmentation (const LabelCloudConstPtr& labels)
{
  if (labels && !labels->points.empty()) {
    labels_ = labels;
    clusters_.clear();
  }
  else
    printError ("setSegmentation",
                "there are no labels: give one per point of the source; "
                "clearSegmentation returns to segments by parameters");
}

void
RegistrationSettings::setSegmentation (const std::vector<pcl::PointIndices>& clusters)
{
  for (const auto& cluster : clusters)
    if (!cluster.indices.empty()) {
      clusters_ = clusters;
      labels_.reset();
      return;
    }
  printError ("setSegmentation",
              "no cluster has a point; clearSegmentation returns to segments by "
              "parameters");
}

void
RegistrationSettings::setCorrespondence (CorrespondenceMethod method)
{
  if (method >= CorrespondenceMethod::Auto &&
      method <= CorrespondenceMethod::NearestNeighbor)
    correspondence_ = method;
  else
    printError ("setCorrespondence", "not a value of CorrespondenceMethod");
}

void
RegistrationSettings::setCloudConstraints (const CloudConstraints& constraints)
{
  std::string why;
  if (constraints.isValid (&why))
    constraints_ = constraints;
  else
    printError ("setCloudConstraints", why);
}

void
RegistrationSettings::clearSegmentation()
{
  labels_.reset();
  clusters_.clear();
}

} // namespace pcl_msf
