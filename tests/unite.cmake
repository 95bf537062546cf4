# cmake -DUNIT=FILE "-DTESTS=FOLDER/NAME.test.cpp;..." -P unite.cmake: several tests as one translation unit, which
# instantiates once what they share. Each keeps its own namespace, so that equal names in two tests do not meet, and its
# own lines in what the compiler says. The includes of all come first.
set(includes "")
set(bodies "")
foreach(test IN LISTS TESTS)
  file(READ ${CMAKE_CURRENT_LIST_DIR}/${test} text)
  string(REGEX MATCHALL "#include [^\n]*" lines "${text}")
  list(APPEND includes ${lines})
  string(REGEX REPLACE "#include [^\n]*" "" text "${text}")
  string(MAKE_C_IDENTIFIER "${test}" name)
  string(APPEND bodies "namespace ${name} {\n#line 1 \"${CMAKE_CURRENT_LIST_DIR}/${test}\"\n${text}}\n")
endforeach()
list(REMOVE_DUPLICATES includes)
list(JOIN includes "\n" includes)
file(WRITE ${UNIT} "${includes}\n${bodies}")
