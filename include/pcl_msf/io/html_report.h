// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/export.h>

#include <string>
#include <utility>
#include <vector>

namespace pcl_msf::io {

/** \brief A picture file and what it shows. */
struct HtmlPicture {
  std::string path;
  std::string caption;
};

/** \brief Two pictures of one size to be compared with a slider. */
struct HtmlComparison {
  HtmlPicture before;
  HtmlPicture after;
};

/** \brief One pair of frames, or whatever has pictures and numbers of its own. */
struct HtmlEntry {
  std::string name;
  std::vector<std::pair<std::string, std::string>> numbers; ///< name, value
  std::vector<HtmlComparison> comparisons;
  std::vector<HtmlPicture> pictures;
};

/** \brief A table; columns of numbers can be sorted and plotted. */
struct HtmlTable {
  std::string title;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows; ///< as wide as the header
};

struct HtmlReport {
  std::string title;
  std::vector<HtmlTable> tables;
  std::vector<HtmlEntry> entries;
};

/** \brief A page as text.
 *
 * It opens from disk, without a server and without the network: style and script are in
 * it, pictures are linked by paths relative to `folder`. Without JavaScript, pictures
 * and tables are there, sliders and plots are not. Entries with numbers get a table
 * over all entries, too. Tables show three digits of numbers that are not whole, and no
 * empty columns. \param folder where the page will be */
PCL_MSF_EXPORT std::string
htmlPage (const HtmlReport& report, const std::string& folder);

/** \brief Did htmlPage() make this text? */
PCL_MSF_EXPORT bool
isHtmlReport (const std::string& page);

/** \brief Writes `htmlPage` to a file. \throws IoError */
PCL_MSF_EXPORT void
writeHtmlReport (const std::string& path, const HtmlReport& report);

/** \brief Reads comma-separated values (RFC 4180: quotes, doubled quotes, line ends in
 * quotes), the first line being the header, after comments (#) as pcl_msf_evaluate
 * writes them. Short lines are filled up with empty cells. \throws IoError for an empty
 * file, a line longer than the header, an open quote */
PCL_MSF_EXPORT HtmlTable
readCsvTable (const std::string& path);

/** \brief Entries from a folder that pcl_msf_scene_flow wrote, one for each reference
 * frame: the numbers of its report and the pictures about it; pictures without a frame
 * in their names, as pcl_msf_render makes them, come with the first. \throws IoError
 * without a report.json or when that is damaged or of another program */
PCL_MSF_EXPORT std::vector<HtmlEntry>
entriesOfFolder (const std::string& folder);

/** \brief The first of entriesOfFolder(). */
PCL_MSF_EXPORT HtmlEntry
entryOfFolder (const std::string& folder);

/** \brief Folders with a report.json in or below a folder, at most three levels deep,
 * sorted by name. */
PCL_MSF_EXPORT std::vector<std::string>
resultFolders (const std::string& folder);

} // namespace pcl_msf::io
