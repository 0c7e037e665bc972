// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "common/command_line.h"
#include "common/output_folder.h"
#include "support/temporary_folder.h"
#include <gmock/gmock.h>
#include <pcl_msf/errors.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::tool;
using namespace pcl_msf::testing;

namespace fs = std::filesystem;

TEST (InputFiles, KnowsFilesByMoreThanTheirNames)
{
  const TemporaryFolder folder;
  fs::create_directories (folder ("in/deep"));
  writeFile (folder ("in/deep/a.png"), "a");
  writeFile (folder ("b.png"), "a");
  fs::create_directory_symlink (folder ("in"), folder ("in/deep/up")); // a circle
  fs::create_symlink (folder ("b.png"), folder ("in/link.png"));
  fs::create_hard_link (folder ("in/deep/a.png"), folder ("hard.png"));
  InputFiles inputs;
  inputs.add (folder ("in"));
  EXPECT_NE (inputs.sameAs (folder ("hard.png")), "");
  EXPECT_EQ (inputs.sameAs (folder ("b.png")), folder ("in/link.png"));
  EXPECT_EQ (inputs.sameAs (folder ("in/../in")), folder ("in"));
  writeFile (folder ("c.png"), "a");
  EXPECT_EQ (inputs.sameAs (folder ("c.png")), "") << "the same content only";
  EXPECT_EQ (inputs.sameAs (folder ("in/deep/none.png")), "");
  EXPECT_THROW (requireNoInput ("--output", folder ("b.png"), inputs), UsageError);
}

/** One run that writes files of some names. */
void
writeRun (const TemporaryFolder& folder, const std::vector<std::string>& names)
{
  OutputFolder output (folder ("out"), "tool");
  for (const std::string& name : names) {
    fs::create_directories (fs::path (output.stage() + "/" + name).parent_path());
    writeFile (output.stage() + "/" + name, "of a run: " + name);
  }
  output.finish();
}

TEST (OutputFolder, RemovesItsOwnFilesOnly)
{
  const TemporaryFolder folder;
  writeRun (folder, {"a", "b", "sub/c"});
  writeFile (folder ("out/mine"), "mine");
  writeFile (folder ("out/b"), "mine now");
  fs::copy (folder ("out"), folder ("copy"), fs::copy_options::recursive);
  writeRun (folder, {"a"});
  EXPECT_EQ (readFile (folder ("out/a")), "of a run: a");
  EXPECT_EQ (readFile (folder ("out/b")), "mine now");
  EXPECT_EQ (readFile (folder ("out/mine")), "mine");
  EXPECT_FALSE (fs::exists (folder ("out/sub")));
  fs::remove_all (folder ("out"));
  fs::rename (folder ("copy"), folder ("out"));
  EXPECT_THROW (writeRun (folder, {"b"}), UsageError) << "known in a copy, too";
  EXPECT_EQ (readFile (folder ("out/b")), "mine now");
  EXPECT_TRUE (fs::exists (folder ("out/sub/c"))) << "a refused run removes nothing";
}

TEST (OutputFolder, ALinkInPlaceOfAFileIsTheUsers)
{
  const TemporaryFolder folder;
  writeRun (folder, {"a"});
  fs::rename (folder ("out/a"), folder ("elsewhere"));
  fs::create_symlink (folder ("elsewhere"), folder ("out/a"));
  EXPECT_THROW (writeRun (folder, {"a"}), UsageError);
  writeRun (folder, {"b"});
  EXPECT_TRUE (fs::is_symlink (folder ("out/a")));
  EXPECT_EQ (readFile (folder ("elsewhere")), "of a run: a");
}

TEST (OutputFolder, AnotherToolsFilesAreNotItsOwn)
{
  const TemporaryFolder folder;
  writeRun (folder, {"a"});
  OutputFolder output (folder ("out"), "other");
  writeFile (output.stage() + "/b", "b");
  output.finish();
  EXPECT_TRUE (fs::exists (folder ("out/a")));
}

TEST (OutputFolder, TrustsNoListThatLeadsOutside)
{
  const TemporaryFolder folder;
  writeRun (folder, {"a"});
  writeFile (folder ("victim"), "of a run: a");
  std::string list = readFile (folder ("out/.tool"));
  list.replace (list.rfind ("\ta\n"), 3, "\t../victim\n");
  writeFile (folder ("out/.tool"), list);
  EXPECT_THROW (writeRun (folder, {"b"}), IoError);
  EXPECT_TRUE (fs::exists (folder ("victim")));
}

TEST (OutputFolder, GoesOnWithAListThatWasCutOff)
{
  for (const std::size_t kept : {std::size_t{0}, std::size_t{9}, std::string::npos}) {
    const TemporaryFolder folder;
    writeRun (folder, {"a"});
    const std::string list = readFile (folder ("out/.tool"));
    writeFile (folder ("out/.tool"), list.substr (0, std::min (kept, list.size() - 2)));
    fs::remove (folder ("out/a"));
    {
      OutputFolder output (folder ("out"), "tool");
      writeFile (output.stage() + "/b", "b");
      output.publish(); // and is killed before it finishes
      fs::copy (folder ("out"), folder ("killed"));
    }
    fs::remove_all (folder ("out"));
    fs::rename (folder ("killed"), folder ("out"));
    EXPECT_NO_THROW (writeRun (folder, {"b"})) << kept;
  }
}

TEST (OutputFolder, FilesOfAFirstRunAppearAtOnce)
{
  const TemporaryFolder folder;
  {
    OutputFolder output (folder ("out"), "tool");
    writeFile (output.stage() + "/a", "a");
    output.publish();
    EXPECT_TRUE (fs::exists (folder ("out/a")));
    writeFile (output.stage() + "/half", "b");
  }
  EXPECT_FALSE (fs::exists (folder ("out/half"))) << "the run failed";
  EXPECT_EQ (filesIn (folder ("out")), 2U) << "the file and the list";
  writeRun (folder, {"c"});
  EXPECT_FALSE (fs::exists (folder ("out/a"))) << "known though its run failed";
}

/** Names of hidden folders. */
std::vector<std::string>
stagesIn (const std::string& folder)
{
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator (folder))
    if (entry.is_directory() && entry.path().filename().string().front() == '.')
      names.push_back (entry.path().string());
  return names;
}

TEST (OutputFolder, TheStageOfAKilledRunGoesWithTheNextRun)
{
  const TemporaryFolder folder;
  const pid_t child = fork();
  if (child == 0) {
    const OutputFolder output (folder ("out"), "tool");
    writeFile (output.stage() + "/half", "a");
    raise (SIGKILL);
  }
  int status = 0;
  waitpid (child, &status, 0);
  ASSERT_TRUE (WIFSIGNALED (status));
  ASSERT_EQ (stagesIn (folder ("out")).size(), 1U);
  fs::create_directories (folder ("out/.tool.mine00")); // nobody's lock is in it
  fs::create_directories (folder ("out/.other.abcdef"));
  writeFile (folder ("out/.other.abcdef/.lock"), "");
  writeRun (folder, {"a"});
  const std::vector<std::string> left = stagesIn (folder ("out"));
  EXPECT_THAT (left,
               ::testing::UnorderedElementsAre (folder ("out/.tool.mine00"),
                                                folder ("out/.other.abcdef")));
}

TEST (OutputFolder, TheStageOfARunThatGoesOnStays)
{
  const TemporaryFolder folder;
  OutputFolder output (folder ("out"), "tool");
  writeFile (output.stage() + "/a", "a");
  writeRun (folder, {"b"});
  output.finish();
  EXPECT_EQ (readFile (folder ("out/a")), "a");
}

} // namespace
