# The libraries of touchstone_number_libraries, which a program links beside touchstone, as targets: touchstone::gmp and,
# with CGAL, touchstone::mpfr. Their headers are not needed, so finding the libraries is enough. Used by the build and
# installed for the package config; it leaves the names of what it did not find in touchstone_missing_libraries.
# SPDX-License-Identifier: MIT
set(touchstone_missing_libraries "")
foreach(touchstone_library ${touchstone_number_libraries})
  if(NOT TARGET touchstone::${touchstone_library})
    find_library(touchstone_${touchstone_library}_LIBRARY ${touchstone_library})
    mark_as_advanced(touchstone_${touchstone_library}_LIBRARY)
    if(touchstone_${touchstone_library}_LIBRARY)
      add_library(touchstone::${touchstone_library} UNKNOWN IMPORTED GLOBAL)
      set_target_properties(touchstone::${touchstone_library} PROPERTIES
        IMPORTED_LOCATION "${touchstone_${touchstone_library}_LIBRARY}")
    else()
      list(APPEND touchstone_missing_libraries ${touchstone_library})
    endif()
  endif()
endforeach()
unset(touchstone_library)
