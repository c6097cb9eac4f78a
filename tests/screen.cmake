# KALOS_SCREEN: what to put in front of a test that draws with OpenGL; nothing where there is no virtual screen to start.
find_program(KALOS_XVFB Xvfb)
set(KALOS_SCREEN)
if (KALOS_XVFB)
  set(KALOS_SCREEN "${PROJECT_SOURCE_DIR}/tests/with_screen")
endif ()
