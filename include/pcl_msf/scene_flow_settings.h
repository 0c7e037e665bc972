// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/export.h>
#include <pcl_msf/multiframe_scene_flow.h>
#include <pcl_msf/parameters.h>
#include <pcl_msf/pinhole_camera.h>

#include <functional>
#include <string>

namespace pcl_msf {

/** \brief What a user sets on every class that finds the scene flow of clouds, whatever
 * their point type.
 *
 * Every setter checks its argument: a bad one is refused with a PCL_ERROR that names
 * the class and the allowed values, and the old one stays. Every setter has a getter of
 * the same type. What can only be judged with the clouds (sizes) is judged with them.
 *
 * Not thread-safe: don't set while another thread uses the object.
 */
class PCL_MSF_EXPORT SceneFlowSettings {
public:
  using ProgressCallback = std::function<bool (const Progress&)>;

  /** \brief The camera of both clouds, pixels (Eq. 2). Refused unless finite with
   * positive focal lengths. Without it each align estimates it from the source, see
   * estimateCamera. Either way all clouds must fit it, see fitsCamera; beyond that
   * their x and y are not used for the estimation. */
  void
  setCamera (const PinholeCamera& camera);

  /** \brief As set; all zero when it is to be estimated. The one that was used is
   * `getSceneFlow ().camera`. */
  PinholeCamera
  getCamera () const
  {
    return camera_;
  }

  /** \brief Back to estimating the camera from the source. */
  void
  clearCamera ()
  {
    camera_ = {};
  }

  /** \brief How frames are prepared (section 3.3). */
  void
  setFrameParameters (const FrameParameters& parameters);
  FrameParameters
  getFrameParameters () const
  {
    return frame_;
  }

  /** \brief How the source is cut into segments (section 3.3). No effect while a
   * segmentation from outside is set. */
  void
  setSegmentationParameters (const SegmentationParameters& parameters);
  SegmentationParameters
  getSegmentationParameters () const
  {
    return segmentation_;
  }

  /** \brief Weights and norms of the energy (Eq. 5). */
  void
  setEnergyParameters (const EnergyParameters& parameters);
  EnergyParameters
  getEnergyParameters () const
  {
    return energy_;
  }

  /** \brief Sets `method` of SegmentationParameters alone, default TangentPlane; Single
   * makes the whole scene one rigid body: for static scenes, the camera's motion. */
  void
  setSegmentationMethod (SegmentationMethod method);
  SegmentationMethod
  getSegmentationMethod () const
  {
    return segmentation_.method;
  }

  /** \brief Weights and rules for several targets (Eq. 13 and 14). */
  void
  setMultiframeParameters (const MultiframeParameters& parameters);
  MultiframeParameters
  getMultiframeParameters () const
  {
    return multiframe_;
  }

  /** \brief Sets `threads` of SolverParameters alone: threads to use, at most 1024; 0 =
   * one per processor. The result does not depend on it.
   *
   * With 1, all is done in the thread that calls align: no thread is started, and
   * OpenCV's loops are not split (see cv::setNumThreads for its own threads, used with
   * more). More are helpers of the calling thread; they sleep while nothing is shared,
   * and end with it. A process that was forked after an align may align, too. */
  void
  setNumberOfThreads (unsigned threads = 0);
  unsigned
  getNumberOfThreads () const
  {
    return solver_.threads;
  }

  /* Former shortcuts, which go with the next release: each sets one member of a
   * structure that has a setter. */

  /** \deprecated Sets the method to Single, or from Single to TangentPlane. */
  [[deprecated ("use setSegmentationMethod (SegmentationMethod::Single)")]] void
  setRigid (bool rigid)
  {
    if (rigid != (segmentation_.method == SegmentationMethod::Single))
      segmentation_.method =
          rigid ? SegmentationMethod::Single : SegmentationMethod::TangentPlane;
  }
  [[deprecated ("use getSegmentationMethod")]] bool
  isRigid () const
  {
    return segmentation_.method == SegmentationMethod::Single;
  }
  [[deprecated ("use segment_size of SegmentationParameters")]] void
  setSegmentSize (int pixels)
  {
    SegmentationParameters parameters = segmentation_;
    parameters.segment_size = pixels;
    setSegmentationParameters (parameters);
  }
  [[deprecated ("use segment_size of SegmentationParameters")]] int
  getSegmentSize () const
  {
    return segmentation_.segment_size;
  }
  [[deprecated ("use regularizer_weight of EnergyParameters")]] void
  setRegularizerWeight (double gamma)
  {
    EnergyParameters parameters = energy_;
    parameters.regularizer_weight = gamma;
    setEnergyParameters (parameters);
  }
  [[deprecated ("use regularizer_weight of EnergyParameters")]] double
  getRegularizerWeight () const
  {
    return energy_.regularizer_weight;
  }
  [[deprecated ("use max_seconds of SolverParameters")]] void
  setTimeBudget (double seconds)
  {
    SolverParameters parameters = solver_;
    parameters.max_seconds = seconds;
    takeSolverParameters (parameters, "setTimeBudget");
  }
  [[deprecated ("use max_seconds of SolverParameters")]] double
  getTimeBudget () const
  {
    return solver_.max_seconds;
  }
  [[deprecated ("use progress of SolverParameters")]] void
  setProgressCallback (const ProgressCallback& callback)
  {
    solver_.progress = callback;
  }
  [[deprecated ("use progress of SolverParameters")]] ProgressCallback
  getProgressCallback () const
  {
    return solver_.progress;
  }

protected:
  /** \param owner name of the class that has the settings; a literal */
  explicit SceneFlowSettings (const char* owner) : owner_ (owner) {}
  ~SceneFlowSettings() = default;

  /** Takes the parameters or says why not. \return were they taken? */
  bool
  takeSolverParameters (const SolverParameters& parameters, const char* method);

  /** Prints "[pcl_msf::owner::method] why". */
  void
  printError (const char* method, const std::string& why) const;

  PinholeCamera camera_;
  FrameParameters frame_;
  SegmentationParameters segmentation_;
  EnergyParameters energy_;
  SolverParameters solver_;
  MultiframeParameters multiframe_;

private:
  const char* owner_;
};

} // namespace pcl_msf
