// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "common/input_files.h"
#include "common/output_manifest.h"
#include "common/stage_folder.h"

#include <functional>
#include <string>
#include <vector>

namespace pcl_msf::tool {

/** \brief A folder that a tool writes results into, and with it nobody else's files.
 *
 * A run writes into `stage()`, a hidden folder inside, and publishes what is complete.
 * Files that an earlier run of the tool left are removed once the new run has finished;
 * until then they stay as they are and the new ones wait. When there are none, new
 * files appear as they are published. A file that the tool has not written, or that was
 * changed since, is neither replaced nor removed. A run that fails leaves what it had
 * published beside the earlier results, in `unfinished`. The stage of a run that was
 * killed goes when the tool writes into the folder again. */
class OutputFolder {
public:
  /** \brief Which file of an earlier run stays, by its name and group. */
  using Keep = std::function<bool (const std::string& name, const std::string& group)>;

  /** \brief Makes the folder when it is missing. \param group of this run's files, see
   * OutputManifest \param option that names the folder, for messages \throws IoError */
  OutputFolder (std::string folder,
                std::string tool,
                std::string group = {},
                std::string option = "--output");

  /** \brief Publishes to `unfinished` what waits and throws the rest of the stage away.
   */
  ~OutputFolder();
  OutputFolder (const OutputFolder&) = delete;
  OutputFolder&
  operator= (const OutputFolder&) = delete;

  /** \brief Sets which earlier files stay beside those of this run; none by default. */
  void
  keep (const Keep& keep);

  /** \brief Before any work: \throws UsageError when a file that is there is an input,
   * or is not the tool's and in its way.
   * \param written is a file of that name in the way? Asked about what is in the folder
   * and, when it says so of "name/", in that one */
  void
  check (const InputFiles& inputs,
         const std::function<bool (const std::string& name)>& written) const;

  /** \brief That of this run's files, as it is noted: one word of a line. */
  const std::string&
  group () const
  {
    return group_;
  }

  /** \brief Where to write; names are those in the folder. */
  const std::string&
  stage () const
  {
    return stage_.path();
  }

  /** \brief Where a file of this run is at present. */
  std::string
  locate (const std::string& name) const;

  /** \brief All files of the stage are complete. \throws UsageError when one of them
   * would replace a file that is not the tool's \throws IoError */
  void
  publish ();

  /** \brief The run is complete: publishes, and removes what earlier runs left.
   * \throws UsageError, IoError as publish() */
  void
  finish ();

private:
  void
  requireOwn (const std::vector<std::string>& names) const;
  void
  move (const std::vector<std::string>& names);
  void
  keepUnfinished ();

  std::string folder_;
  std::string tool_;
  std::string group_;
  std::string option_;
  StageFolder stage_;
  OutputManifest manifest_;
  std::vector<std::string> earlier_; ///< names that are to go in the end
  std::vector<std::string> waiting_; ///< published, still in the stage
};

} // namespace pcl_msf::tool
