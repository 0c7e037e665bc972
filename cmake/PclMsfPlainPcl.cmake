# SPDX-License-Identifier: BSD-3-Clause
# PCL's config ties VTK to the features and io targets although libpcl_features needs
# none of it. These targets name the libraries alone. The installed config includes this
# file, too, after find_package (PCL).

# pcl_msf_plain_pcl (<component>): target pcl_msf::plain_pcl_<component>, if not there yet.
function (pcl_msf_plain_pcl component)
  if (TARGET pcl_msf::plain_pcl_${component})
    return ()
  endif ()
  get_target_property (common_library pcl_common IMPORTED_LOCATION)
  if (NOT common_library)
    get_target_property (common_library pcl_common IMPORTED_LOCATION_RELEASE)
  endif ()
  get_filename_component (library_dir "${common_library}" DIRECTORY)
  find_library (PCL_MSF_PCL_${component}_LIBRARY pcl_${component} HINTS ${library_dir})
  mark_as_advanced (PCL_MSF_PCL_${component}_LIBRARY)
  if (NOT PCL_MSF_PCL_${component}_LIBRARY)
    message (FATAL_ERROR
      "pcl_msf needs PCL's ${component} library: sudo apt-get install libpcl-dev")
  endif ()
  add_library (pcl_msf::plain_pcl_${component} INTERFACE IMPORTED GLOBAL)
  target_link_libraries (pcl_msf::plain_pcl_${component} INTERFACE
    ${PCL_MSF_PCL_${component}_LIBRARY} pcl_common pcl_search)
endfunction ()

pcl_msf_plain_pcl (features)
pcl_msf_plain_pcl (io)
