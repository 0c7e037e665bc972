// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// Renders an RGB-D sequence with exact truth into a folder.

#include <pcl/console/parse.h>
#include <pcl/console/print.h>
#include <pcl/console/time.h>

#include <pcl_msf/errors.h>
#include <pcl_msf/synthetic/sequence_writer.h>
#include <pcl_msf/synthetic/synthetic_sequence.h>

#include <exception>
#include <string>
#include <vector>

using namespace pcl::console;

namespace {

void
printHelp (const char* program)
{
  print_info ("Renders an RGB-D sequence with exact scene flow, optical flow,\n");
  print_info ("visibility, labels and poses.\n\n");
  print_info ("Syntax: %s folder <options>\n\n", program);
  print_info ("  -scene X          one of");
  for (const pcl_msf::Scene scene : pcl_msf::allScenes())
    print_value (" %s", pcl_msf::toString (scene));
  print_info (" (default: multi_body)\n");
  print_info ("  -motion X         easy (4 px a frame) or large (22 px) (easy)\n");
  print_info ("  -motion_pixels X  average motion a frame at 640 px width instead\n");
  print_info ("  -sensor X         none or kinect (none)\n");
  print_info ("  -width X          pixels (640)\n");
  print_info ("  -height X         pixels (480)\n");
  print_info ("  -frames X         (2)\n");
  print_info ("  -seed X           places, colours, motions, noise (1)\n");
  print_info ("  -samples X        colour rays per pixel and axis (3)\n");
  print_info ("  -blur 0/1         motion blur (0)\n");
  print_info ("  -threads X        0 = all; no influence on the result (0)\n");
  print_info ("  -layout X         cases, tum or sintel (cases)\n");
  print_info (
      "  -depth X          cases: auto, dpt or png (auto: dpt without sensor)\n");
  print_info ("  -depth_scale X    16-bit depth units per metre (5000)\n");
}

/** Reads a word and finds its place in a list of choices. */
int
choice (int argc,
        char** argv,
        const char* option,
        const std::vector<std::string>& names)
{
  std::string word;
  if (parse_argument (argc, argv, option, word) < 0)
    return 0;
  std::string all;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (word == names[i])
      return static_cast<int> (i);
    all += " " + names[i];
  }
  throw pcl_msf::InvalidInput (std::string (option) + " " + word + ": choose one of" +
                               all);
}

pcl_msf::SequenceOptions
sequenceOptions (int argc, char** argv)
{
  pcl_msf::SequenceOptions options;
  std::string scene = pcl_msf::toString (options.scene);
  parse_argument (argc, argv, "-scene", scene);
  options.scene = pcl_msf::sceneFromName (scene);
  if (choice (argc, argv, "-motion", {"easy", "large"}) == 1)
    options.motion = pcl_msf::MotionSize::Large;
  if (choice (argc, argv, "-sensor", {"none", "kinect"}) == 1)
    options.sensor = pcl_msf::Sensor::Kinect;
  parse_argument (argc, argv, "-motion_pixels", options.motion_pixels);
  parse_argument (argc, argv, "-width", options.width);
  parse_argument (argc, argv, "-height", options.height);
  parse_argument (argc, argv, "-frames", options.frames);
  parse_argument (argc, argv, "-seed", options.seed);
  parse_argument (argc, argv, "-samples", options.supersampling);
  parse_argument (argc, argv, "-blur", options.motion_blur);
  parse_argument (argc, argv, "-threads", options.threads);
  return options;
}

pcl_msf::SequenceWriterOptions
writerOptions (int argc, char** argv)
{
  using namespace pcl_msf;
  SequenceWriterOptions options;
  const SequenceLayout layouts[] = {
      SequenceLayout::Cases, SequenceLayout::Tum, SequenceLayout::Sintel};
  options.layout = layouts[choice (argc, argv, "-layout", {"cases", "tum", "sintel"})];
  const DepthFormat formats[] = {
      DepthFormat::Automatic, DepthFormat::Float, DepthFormat::Png16};
  options.depth_format = formats[choice (argc, argv, "-depth", {"auto", "dpt", "png"})];
  parse_argument (argc, argv, "-depth_scale", options.depth_scale);
  return options;
}

} // namespace

int
main (int argc, char** argv)
{
  if (argc < 2 || find_switch (argc, argv, "-h") ||
      find_switch (argc, argv, "--help") || argv[1][0] == '-') {
    printHelp (argv[0]);
    return argc < 2 || argv[1][1] != 'h' ? 1 : 0;
  }
  try {
    pcl_msf::SequenceOptions options = sequenceOptions (argc, argv);
    const pcl_msf::SequenceWriterOptions writing = writerOptions (argc, argv);
    options.successive_truth = writing.layout == pcl_msf::SequenceLayout::Sintel;
    TicToc clock;
    clock.tic();
    const pcl_msf::SyntheticSequence sequence = pcl_msf::synthesize (options);
    const double seconds = clock.toc() / 1000.0;
    pcl_msf::writeSequence (sequence, argv[1], writing);
    print_info ("%d frames of %s in %.2f s, written to %s\n",
                options.frames,
                pcl_msf::toString (options.scene),
                seconds,
                argv[1]);
  }
  catch (const std::exception& problem) {
    print_error ("%s\n", problem.what());
    return 1;
  }
  return 0;
}
