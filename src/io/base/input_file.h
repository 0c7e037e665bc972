// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/export.h>

#include <cstdint>
#include <fstream>
#include <optional>
#include <string>

namespace pcl_msf::io {

/** \brief A file being read, whose every failure is an IoError naming file and field.
 */
class PCL_MSF_EXPORT InputFile {
public:
  /** \throws IoError when the path is no readable file */
  explicit InputFile (const std::string& path);

  const std::string&
  path () const
  {
    return path_;
  }

  /** \brief Bytes from the present position to the end. */
  std::uint64_t
  remaining ();

  /** \brief Reads exactly that many bytes. \param field what they are, for the error */
  void
  read (void* to, std::uint64_t bytes, const std::string& field);

  template <typename T>
  T
  value (const std::string& field)
  {
    T result{};
    read (&result, sizeof (T), field);
    return result;
  }

  /** \brief Characters up to the next white space, which is consumed, at most 64. */
  std::string
  word (const std::string& field);

  /** \brief Characters up to the next line end, which is consumed, at most 64 k. */
  std::string
  line (const std::string& field);

  /** \brief The next line that has more than white space, without its end; nothing
   * when there is none. The last one of a file need not have an end. */
  std::optional<std::string>
  filledLine ();

  /** \brief Passes over the mark that some editors begin UTF-8 text with.
   * \throws IoError for UTF-16 text */
  void
  skipByteOrderMark ();

  /** \brief The whole rest as text, without a byte order mark. \param most bytes that
   * are read, 1 MB unless given \throws IoError for longer files */
  std::string
  text (std::uint64_t most = std::uint64_t{1} << 20);

  /** \brief Throws IoError "<path>: <field>: <problem>". */
  [[noreturn]] void
  fail (const std::string& field, const std::string& problem) const;

private:
  std::string path_;
  std::ifstream stream_;
  std::uint64_t size_{0};
};

/** \brief Refuses image sizes that no sensor has, before anything is allocated.
 * \throws IoError naming file and field */
PCL_MSF_EXPORT void
checkImageSize (const std::string& path, std::int64_t width, std::int64_t height);

/** \brief Small letters for A to Z, in every locale (a Turkish one has others). */
PCL_MSF_EXPORT std::string
lowerCase (std::string text);

/** \brief Lower-case extension with the dot, e.g. ".png". */
PCL_MSF_EXPORT std::string
lowerExtension (const std::string& path);

} // namespace pcl_msf::io
