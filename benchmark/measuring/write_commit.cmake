# Writes the header that names the commit, when it has changed:
#
#   cmake -DSOURCE_DIR=<folder in the repository> -DHEADER=<file> -P write_commit.cmake
#
# SPDX-License-Identifier: LGPL-3.0-or-later

execute_process(
  COMMAND git describe --always --dirty --abbrev=10
  WORKING_DIRECTORY ${SOURCE_DIR}
  OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET
  RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  set(commit "unknown")
endif()

set(text "#define THICK_BENCHMARK_COMMIT \"${commit}\"\n")
if(EXISTS ${HEADER})
  file(READ ${HEADER} old_text)
endif()
if(NOT text STREQUAL "${old_text}")
  file(WRITE ${HEADER} "${text}")
endif()
