// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "generated.h"

#include <pcl_msf/errors.h>
#include <pcl_msf/io/undistortion.h>
#include <pcl_msf/synthetic/synthetic_sequence.h>

#include <mutex>

namespace pcl_msf::tool {

namespace {

/** The sequence that was rendered last. */
struct LastRendered {
  std::mutex mutex;
  const void* owner{nullptr};
  std::shared_ptr<const synthetic::SyntheticSequence> sequence;
};

class GeneratedSequence : public io::RgbdSequence {
public:
  GeneratedSequence (const synthetic::SequenceOptions& options,
                     const LensDistortion& distortion,
                     std::shared_ptr<LastRendered> last)
  : options_ (options), distortion_ (distortion), last_ (std::move (last))
  {}

  std::string
  name () const override
  {
    return std::string (toString (options_.scene)) +
           (options_.motion == synthetic::MotionSize::Large ? "_large" : "_easy") +
           "_" + toString (options_.sensor) +
           (options_.noise_seed ? "_noise" + std::to_string (*options_.noise_seed)
                                : "");
  }

  int
  frames () const override
  {
    return options_.frames;
  }

  io::RgbdImages
  frame (int k) const override
  {
    const auto sequence = render();
    const synthetic::SyntheticFrame& frame = sequence->frames.at (k);
    io::RgbdImages images{frame.color, frame.depth, sequence->camera};
    io::undistort (images, distortion_);
    return images;
  }

  bool
  definesDepthUnit () const override
  {
    return true;
  }

  io::MotionTruth
  truth (int from, int to) const override;

  std::optional<RigidPose>
  cameraPose (int k) const override
  {
    return render()->frame0_from_framek.at (k);
  }

private:
  std::shared_ptr<const synthetic::SyntheticSequence>
  render () const
  {
    const std::lock_guard<std::mutex> lock (last_->mutex);
    if (last_->owner != this) {
      last_->sequence.reset(); // never two in memory
      last_->sequence = std::make_shared<const synthetic::SyntheticSequence> (
          synthetic::synthesize (options_));
      last_->owner = this;
    }
    return last_->sequence;
  }

  synthetic::SequenceOptions options_;
  LensDistortion distortion_; ///< that frames are freed from
  std::shared_ptr<LastRendered> last_;
};

io::MotionTruth
GeneratedSequence::truth (int from, int to) const
{
  io::MotionTruth truth;
  const auto sequence = render();
  if (from == 0 && to > 0) {
    const synthetic::GroundTruth& known = sequence->truth.at (to);
    truth.flow = known.flow;
    truth.scene_flow = known.scene_flow;
    truth.visible = known.visible;
    truth.labels = sequence->labels;
    for (const synthetic::SyntheticBody& body : sequence->bodies)
      truth.bodies.push_back (
          body.rigid ? std::optional (body.framek_from_frame0.at (to)) : std::nullopt);
    if (truth.bodies.size() == 1)
      truth.rigid = truth.bodies[0];
  }
  else if (to == from + 1) {
    const synthetic::GroundTruth& known = sequence->successive_truth.at (from);
    truth.flow = known.flow;
    truth.scene_flow = known.scene_flow;
    truth.visible = known.visible;
  }
  return truth;
}

} // namespace

std::vector<std::shared_ptr<const io::RgbdSequence>>
openGenerated (const GeneratedOptions& options)
{
  std::vector<std::shared_ptr<const io::RgbdSequence>> all;
  const auto last = std::make_shared<LastRendered>();
  synthetic::SequenceOptions one;
  one.width = options.width;
  one.height = options.height;
  one.frames = options.frames;
  one.seed = options.seed;
  one.threads = options.threads;
  one.effects = options.effects;
  one.motion_blur = options.motion_blur;
  one.successive_truth = options.frames > 2;
  std::string why;
  if (!one.isValid (&why))
    throw InvalidInput ("generated: " + why);
  for (const synthetic::Sensor sensor : options.sensors)
    for (const synthetic::SceneKind scene : options.scenes)
      for (const synthetic::MotionSize motion : options.motions) {
        one.scene = scene;
        one.motion = motion;
        one.sensor = sensor;
        for (int noise = 0; noise < options.noise_seeds; ++noise) {
          if (options.noise_seeds > 1)
            one.noise_seed = noise;
          all.push_back (std::make_shared<GeneratedSequence> (
              one, options.distortion.value_or (LensDistortion()), last));
        }
      }
  return all;
}

} // namespace pcl_msf::tool
