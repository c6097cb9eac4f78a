# Compiler and layout defaults for every target.
include(GNUInstallDirs)

if (NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif ()

# Python wrapping and the ParaView plugin load the modules at run time.
option(BUILD_SHARED_LIBS "Build shared libraries" ON)

set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/lib")
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/lib")

# Installed libraries find each other wherever the prefix is moved to.
set(CMAKE_INSTALL_RPATH "$ORIGIN")
set(KALOS_CMAKE_DIRECTORY "${CMAKE_INSTALL_LIBDIR}/cmake/Kalos")

find_program(CCACHE_PROGRAM ccache)
if (CCACHE_PROGRAM)
  set(CMAKE_C_COMPILER_LAUNCHER "${CCACHE_PROGRAM}")
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CCACHE_PROGRAM}")
endif ()

if (KALOS_SANITIZE)
  add_compile_options(-fsanitize=${KALOS_SANITIZE} -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${KALOS_SANITIZE})
endif ()

# Warnings for our own code; VTK's generated wrapping code is not ours.
function (kalos_target_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow)
  if (KALOS_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif ()
endfunction ()
