# kalos_add_pytest(file...): one CTest test per Python file of the current folder, on the package in the build tree, behind the
# command KALOS_PYTEST_FRONT if that is set. Skipped where all that it holds was.
find_package(Python3 COMPONENTS Interpreter REQUIRED)

function (kalos_add_pytest)
  get_filename_component(folder "${CMAKE_CURRENT_SOURCE_DIR}" NAME)
  foreach (file IN LISTS ARGN)
    string(REGEX REPLACE "^test_(.*)\\.py$" "${folder}.\\1" name "${file}")
    add_test(NAME "${name}"
      COMMAND ${KALOS_PYTEST_FRONT} "${Python3_EXECUTABLE}" -m pytest -q -p no:cacheprovider "${CMAKE_CURRENT_SOURCE_DIR}/${file}")
    set_tests_properties("${name}" PROPERTIES
      TIMEOUT 300
      SKIP_REGULAR_EXPRESSION "\n[0-9]+ skipped in "
      ENVIRONMENT "PYTHONDONTWRITEBYTECODE=1;KALOS=${CMAKE_BINARY_DIR}/bin/kalos"
      ENVIRONMENT_MODIFICATION "PYTHONPATH=path_list_prepend:${CMAKE_BINARY_DIR}/python")
  endforeach ()
endfunction ()
