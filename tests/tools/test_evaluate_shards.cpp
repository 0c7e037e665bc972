// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "common/command_line.h"
#include "common/methods/method.h"
#include "common/shard.h"
#include "support/evaluation.h"

#include <cstdlib>
#include <string>
#include <vector>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::tool;
using pcl_msf::testing::messageOf;
using ::testing::HasSubstr;

/** Sets variables of the environment for one test. */
class Launchers : public ::testing::Test {
protected:
  ~Launchers() override
  {
    for (const std::string& name : names_)
      unsetenv (name.c_str());
  }
  void
  set (const std::string& name, const std::string& value)
  {
    setenv (name.c_str(), value.c_str(), 1);
    names_.push_back (name);
  }

private:
  std::vector<std::string> names_;
};

TEST_F (Launchers, SlurmArraysBeginWhereTheyLike)
{
  set ("SLURM_ARRAY_TASK_ID", "12");
  set ("SLURM_ARRAY_TASK_MIN", "10");
  set ("SLURM_ARRAY_TASK_COUNT", "4");
  EXPECT_EQ (parseShard ("auto").text(), "3/4");
}

TEST_F (Launchers, SlurmArraysMayHaveSteps)
{
  set ("SLURM_ARRAY_TASK_ID", "25");
  set ("SLURM_ARRAY_TASK_MIN", "5");
  set ("SLURM_ARRAY_TASK_STEP", "10");
  set ("SLURM_ARRAY_TASK_COUNT", "3");
  EXPECT_EQ (parseShard ("auto").text(), "3/3");
}

TEST_F (Launchers, MpiRanksCountFromZero)
{
  set ("PMI_RANK", "0");
  set ("PMI_SIZE", "3");
  EXPECT_EQ (parseShard ("auto").text(), "1/3");
  set ("OMPI_COMM_WORLD_RANK", "2");
  set ("OMPI_COMM_WORLD_SIZE", "8");
  EXPECT_EQ (parseShard ("auto").text(), "3/8");
}

TEST_F (Launchers, TasksOfSrunCountFromZero)
{
  set ("SLURM_PROCID", "0"); // of a batch script
  set ("SLURM_NTASKS", "1");
  EXPECT_THROW (parseShard ("auto"), UsageError);
  set ("SLURM_PROCID", "1");
  set ("SLURM_NTASKS", "3");
  EXPECT_EQ (parseShard ("auto").text(), "2/3");
}

TEST_F (Launchers, GnuParallelNeedsTheNumber)
{
  set ("PARALLEL_SEQ", "2");
  EXPECT_THROW (parseShard ("auto"), UsageError);
  EXPECT_EQ (parseShard ("auto/5").text(), "2/5");
  EXPECT_THROW (parseShard ("auto/1"), UsageError);
  set ("PARALLEL_SEQ", "two");
  EXPECT_THAT (messageOf<UsageError> ([] { parseShard ("auto/5"); }),
               HasSubstr ("PARALLEL_SEQ='two'"));
}

TEST_F (Launchers, ShardsOutsideTheirRangeAreRefused)
{
  for (const char* text : {"0/3", "4/3", "1", "a/3", "1/x", "1/0", "", "/", "auto"})
    EXPECT_THROW (parseShard (text), UsageError) << text;
  EXPECT_EQ (parseShard ("3/3").text(), "3/3");
}

TEST (Shards, ArePartsOfTheWhole)
{
  for (std::size_t item = 0; item < 10; ++item) {
    int owners = 0;
    for (int i = 1; i <= 4; ++i)
      owners += Shard{i, 4}.has (item) ? 1 : 0;
    EXPECT_EQ (owners, 1);
  }
}

TEST (Methods, UnknownOnesAndSettingsAreRefused)
{
  EXPECT_THAT (messageOf<UsageError> ([] { makeMethod ("horn", 1); }),
               HasSubstr ("dis_medium"));
  EXPECT_THAT (messageOf<UsageError> ([] { makeMethod ("msf:colour=1", 1); }),
               HasSubstr ("no setting 'colour'"));
  EXPECT_THAT (messageOf<UsageError> ([] { makeMethod ("msf:loss=l3", 1); }),
               HasSubstr ("'l3' is no value of loss"));
  EXPECT_THAT (messageOf<UsageError> ([] { makeMethod ("msf:segment-size=1", 1); }),
               HasSubstr ("segment_size"));
  EXPECT_THROW (makeMethod ("msf:output=x", 1), UsageError);
  EXPECT_THAT (
      messageOf<UsageError> ([] { makeMethod ("msf:finest-level=1:start=true", 1); }),
      HasSubstr ("give finest-level=0"));
  EXPECT_NO_THROW (makeMethod ("msf:loss=l1:neighbors=4:labels=cut:start=true", 1));
  EXPECT_NO_THROW (makeMethod ("msf:finest-level=1:labels=cut", 1));
}

} // namespace
