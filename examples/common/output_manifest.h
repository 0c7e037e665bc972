// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace pcl_msf::tool {

/** \brief What a tool has written into a folder, kept there in a hidden file, so that a
 * later run can tell its files from the user's: by name, size and content. */
class OutputManifest {
public:
  struct Entry {
    std::uintmax_t size{0};
    std::uint64_t hash{0};
    std::string group; ///< what the file belongs to; for the tool to choose
  };

  /** \brief Reads what is there; nothing when there is no manifest. \param tool gives
   * it its name \throws IoError when it is damaged */
  OutputManifest (std::string folder, const std::string& tool);

  /** \brief Relative names. */
  const std::map<std::string, Entry>&
  entries () const
  {
    return entries_;
  }

  /** \brief Is the file there and as the tool has written it? */
  bool
  holds (const std::string& name) const;

  /** \brief Notes files, at once on disk. \param source where their content is now
   * \throws IoError */
  void
  add (const std::vector<std::string>& names,
       const std::string& source,
       const std::string& group);

  /** \brief Removes a file unless it was changed, its folder when that gets empty, and
   * forgets it; on disk with the next write(). */
  void
  remove (const std::string& name);

  /** \brief Writes the manifest anew, or removes it when it is empty. \throws IoError
   */
  void
  write () const;

private:
  std::string folder_;
  std::string path_;
  std::string head_;
  std::map<std::string, Entry> entries_;
  bool cut_{false}; ///< the file ends within a line, as a run was killed
};

} // namespace pcl_msf::tool
