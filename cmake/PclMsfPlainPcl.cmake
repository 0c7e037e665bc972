# SPDX-License-Identifier: BSD-3-Clause
# PCL's config ties VTK to the features and io targets although libpcl_features needs
# none of it. These targets name the libraries alone. The installed config includes this
# file, too, after find_package (PCL).
# In: pcl_msf_plain_pcl, the names of components. Made for each, if not there yet: target
# pcl_msf::plain_pcl_<component>. Out: pcl_msf_plain_pcl_missing.

set (pcl_msf_plain_pcl_missing "")
get_target_property (pcl_msf_common_library pcl_common IMPORTED_LOCATION)
if (NOT pcl_msf_common_library)
  get_target_property (pcl_msf_common_library pcl_common IMPORTED_LOCATION_RELEASE)
endif ()
get_filename_component (pcl_msf_pcl_dir "${pcl_msf_common_library}" DIRECTORY)
foreach (pcl_msf_component IN LISTS pcl_msf_plain_pcl)
  set (pcl_msf_target pcl_msf::plain_pcl_${pcl_msf_component})
  set (pcl_msf_variable PCL_MSF_PCL_${pcl_msf_component}_LIBRARY)
  find_library (${pcl_msf_variable} pcl_${pcl_msf_component} HINTS ${pcl_msf_pcl_dir})
  mark_as_advanced (${pcl_msf_variable})
  if (NOT ${pcl_msf_variable})
    list (APPEND pcl_msf_plain_pcl_missing ${pcl_msf_component})
  elseif (NOT TARGET ${pcl_msf_target})
    add_library (${pcl_msf_target} INTERFACE IMPORTED GLOBAL)
    target_link_libraries (${pcl_msf_target} INTERFACE
      ${${pcl_msf_variable}} pcl_common pcl_search)
  endif ()
endforeach ()
unset (pcl_msf_common_library)
unset (pcl_msf_pcl_dir)
unset (pcl_msf_component)
unset (pcl_msf_target)
unset (pcl_msf_variable)
