// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "register/constraint_files.h"

#include "core/base/number_text.h"
#include <pcl_msf/errors.h>

#include <fstream>
#include <functional>
#include <sstream>

namespace pcl_msf::tool {

namespace {

/** Hands on the words of every line that has some; false = they are wrong. */
void
readLines (const std::string& path,
           const char* form,
           const std::function<bool (const std::vector<std::string>&)>& take)
{
  std::ifstream stream (path);
  if (!stream)
    throw IoError (path + ": file: cannot be opened; check the path");
  std::string line;
  for (int number = 1; std::getline (stream, line); ++number) {
    std::istringstream text (line.substr (0, line.find ('#')));
    std::vector<std::string> words;
    for (std::string word; text >> word;)
      words.push_back (word);
    if (!words.empty() && !take (words))
      throw IoError (path + ": line " + std::to_string (number) + ": is not \"" + form +
                     "\"");
  }
}

} // namespace

std::vector<int>
readLabels (const std::string& path)
{
  std::vector<int> labels;
  readLines (path, "LABEL", [&labels] (const std::vector<std::string>& words) {
    int label = 0;
    const bool good = words.size() == 1 && parseNumber (words[0], label);
    labels.push_back (label);
    return good;
  });
  return labels;
}

std::vector<KnownPair>
readPairs (const std::string& path)
{
  std::vector<KnownPair> pairs;
  const char* const form = "SOURCE TARGET [WEIGHT [K]]";
  readLines (path, form, [&pairs] (const std::vector<std::string>& words) {
    KnownPair pair;
    int number = 1; // of the target
    const bool good =
        words.size() >= 2 && words.size() <= 4 && parseNumber (words[0], pair.source) &&
        parseNumber (words[1], pair.target) &&
        (words.size() < 3 || parseNumber (words[2], pair.weight)) &&
        (words.size() < 4 || parseNumber (words[3], number)) && number >= 1;
    pair.cloud = number - 1;
    pairs.push_back (pair);
    return good;
  });
  return pairs;
}

} // namespace pcl_msf::tool
