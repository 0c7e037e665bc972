// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "register/constraint_files.h"

#include "core/base/number_text.h"
#include <pcl_msf/errors.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <sstream>

namespace pcl_msf::tool {

namespace {

using Words = std::vector<std::string>;

[[noreturn]] void
failAt (const std::string& path, int line, const std::string& problem)
{
  throw IoError (path + ": line " + std::to_string (line) + ": " + problem);
}

/** Hands on the words of every line that has some; what is wrong with them, if
 * anything, comes back. \return number of the last line */
int
readLines (const std::string& path,
           const std::function<std::string (const Words& words)>& take)
{
  std::ifstream stream (path);
  if (!stream)
    throw IoError (path + ": file: cannot be opened; check the path");
  const std::string mark = "\xEF\xBB\xBF"; // that some editors begin UTF-8 with
  std::string line;
  int number = 0;
  while (std::getline (stream, line)) {
    if (++number == 1 && line.rfind (mark, 0) == 0)
      line.erase (0, mark.size());
    std::istringstream text (line.substr (0, line.find ('#')));
    Words words;
    for (std::string word; text >> word;)
      words.push_back (word);
    const std::string problem = words.empty() ? std::string() : take (words);
    if (!problem.empty())
      failAt (path, number, problem);
  }
  return number;
}

/** What is wrong with an index of one of so many points. */
std::string
indexProblem (const char* name, int index, const std::string& cloud, std::size_t points)
{
  if (index >= 0 && static_cast<std::size_t> (index) < points)
    return {};
  return std::string (name) + " is " + std::to_string (index) + "; the " + cloud +
         " has " + std::to_string (points) + " points, with indices from 0";
}

/** \param targets number of points of each */
std::string
readPair (const Words& words,
          std::size_t source,
          const std::vector<std::size_t>& targets,
          KnownPair& pair)
{
  int number = 1; // of the target
  const bool good = words.size() >= 2 && words.size() <= 4 &&
                    parseNumber (words[0], pair.source) &&
                    parseNumber (words[1], pair.target) &&
                    (words.size() < 3 || parseNumber (words[2], pair.weight)) &&
                    (words.size() < 4 || parseNumber (words[3], number));
  if (!good)
    return "is not \"SOURCE TARGET [WEIGHT [K]]\"";
  const auto count = static_cast<int> (targets.size());
  if (number < 1 || number > count)
    return "K is " + words[3] + ", and there " +
           (count == 1 ? "is 1 target" : "are " + std::to_string (count) + " targets") +
           ", counted from 1";
  if (!(pair.weight > 0.0 && pair.weight <= 1e9))
    return "WEIGHT is " + words[2] + ", must be greater than 0 and at most 1e9";
  pair.cloud = number - 1;
  const std::string problem = indexProblem ("SOURCE", pair.source, "source", source);
  const std::string cloud = count == 1 ? "target" : "target " + std::to_string (number);
  return problem.empty()
             ? indexProblem ("TARGET", pair.target, cloud, targets[pair.cloud])
             : problem;
}

} // namespace

std::vector<int>
readLabels (const std::string& path, std::size_t points)
{
  std::vector<int> labels;
  const std::string have =
      "the source has " + std::to_string (points) + " points; give a label for each";
  const int last = readLines (path, [&] (const Words& words) -> std::string {
    if (words.size() != 1 || !parseNumber (words[0], labels.emplace_back()))
      return "is not \"LABEL\"";
    return labels.size() > points ? "one label too many, " + have : std::string();
  });
  if (labels.size() < points)
    failAt (path,
            std::max (last, 1),
            "the file ends after " + std::to_string (labels.size()) + " labels, " +
                have);
  if (std::all_of (labels.begin(), labels.end(), [] (int label) { return label < 0; }))
    throw IoError (path + ": labels: all are negative, so no point is in a segment; "
                          "give some from 0");
  return labels;
}

std::vector<KnownPair>
readPairs (const std::string& path,
           std::size_t source,
           const std::vector<std::size_t>& targets)
{
  std::vector<KnownPair> pairs;
  readLines (path, [&] (const Words& words) {
    return readPair (words, source, targets, pairs.emplace_back());
  });
  return pairs;
}

} // namespace pcl_msf::tool
