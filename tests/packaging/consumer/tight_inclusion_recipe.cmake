# A recipe of the sort that projects keep for Tight-Inclusion: it is taken from where it is, if its target exists.
# SPDX-License-Identifier: MIT
if(TARGET tight_inclusion::tight_inclusion)
  return()
endif()
message(FATAL_ERROR "this recipe would fetch Tight-Inclusion")
