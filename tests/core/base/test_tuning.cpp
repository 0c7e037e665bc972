// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/base/tuning/tuning.h"
#include <gmock/gmock.h>
#include <pcl_msf/errors.h>

#include <algorithm>
#include <locale>
#include <set>

namespace {

using namespace pcl_msf;

using testing::HasSubstr;

double
numberOf (const TunedValue& value)
{
  return std::visit ([] (const auto* place) { return static_cast<double> (*place); },
                     value.place);
}

/** \return why a value was refused, empty when it was taken */
std::string
refusal (const std::string& name, const std::string& text)
{
  try {
    setTuning (name, text);
  }
  catch (const InvalidInput& e) {
    return e.what();
  }
  return {};
}

/** Leaves the process' values as they were. */
class TuningTest : public testing::Test {
protected:
  void
  TearDown () override
  {
    Tuning defaults;
    for (const TunedValue& value : tunedValues (defaults))
      setTuning (value.name, valueText (value));
  }
};

TEST_F (TuningTest, EveryValueHasANameAndAPlaceOfItsOwn)
{
  Tuning tuning;
  std::set<std::string> names;
  std::set<const void*> places;
  for (const TunedValue& value : tunedValues (tuning)) {
    EXPECT_TRUE (names.insert (value.name).second) << value.name;
    const void* place =
        std::visit ([] (auto* p) { return static_cast<const void*> (p); }, value.place);
    EXPECT_TRUE (places.insert (place).second) << value.name;
  }
}

TEST_F (TuningTest, RangesHoldTheDefaultsAndTheirEnds)
{
  Tuning tuning;
  for (const TunedValue& value : tunedValues (tuning)) {
    EXPECT_LT (value.least, value.most) << value.name;
    EXPECT_LE (value.least, numberOf (value)) << value.name;
    EXPECT_GE (value.most, numberOf (value)) << value.name;
  }
}

TEST_F (TuningTest, AreSetByTextAndPrintedAsTheSameNumber)
{
  EXPECT_EQ (refusal ("points.limbs.anchors", "33"), "");
  EXPECT_EQ (refusal ("surface.overlap", "1.7"), "");
  EXPECT_EQ (refusal ("start.lost", "0.123456789012345"), "");
  const Tuning& now = currentTuning();
  EXPECT_EQ (now.points.limbs.anchors, 33);
  EXPECT_EQ (now.surface.overlap, 1.7f);
  EXPECT_EQ (now.start.lost, 0.123456789012345);
  using Pair = std::pair<std::string, std::string>;
  EXPECT_THAT (changedTuning(),
               testing::UnorderedElementsAre (Pair{"points.limbs.anchors", "33"},
                                              Pair{"surface.overlap", "1.7"},
                                              Pair{"start.lost", "0.123456789012345"}));
}

TEST_F (TuningTest, TheHashTellsEachValue)
{
  Tuning tuning;
  std::set<std::string> hashes{tuningHash (tuning)};
  EXPECT_EQ (hashes.begin()->size(), 16U);
  EXPECT_EQ (tuningHash (Tuning()), *hashes.begin());
  for (const TunedValue& value : tunedValues (tuning)) {
    const Tuning kept = tuning;
    std::visit ([] (auto* place) { *place += 1; }, value.place);
    EXPECT_TRUE (hashes.insert (tuningHash (tuning)).second) << value.name;
    tuning = kept;
  }
}

TEST_F (TuningTest, RefusesUnknownNamesAndBadNumbers)
{
  EXPECT_THAT (refusal ("start.luck", "1"), HasSubstr ("no tuned value 'start.luck'"));
  EXPECT_THAT (refusal ("start.lost", "1.5"), HasSubstr ("a number from 0 to 1"));
  for (const char* text : {"", "much", "nan", "0.5 ", "0,5"})
    EXPECT_THAT (refusal ("start.lost", text), HasSubstr ("start.lost is '")) << text;
  EXPECT_THAT (refusal ("solve.spreads", "1.5"), HasSubstr ("a whole number"));
  EXPECT_TRUE (changedTuning().empty());
}

} // namespace
