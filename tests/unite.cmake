# cmake -DUNIT=FILE "-DTESTS=FOLDER/NAME.test.cpp;..." [-DFOLDER=PATH] [-DPREFIX=ON] -P unite.cmake: several tests, or
# other sources of the folder PATH, as one translation unit, which instantiates once what they share; with PREFIX the
# names of tests begin with that of their folder. Each keeps its own namespace, so that equal names in two tests do not meet, and its
# own lines in what the compiler says. The includes of all come first.
if(NOT FOLDER)
  set(FOLDER ${CMAKE_CURRENT_LIST_DIR})
endif()
set(includes "")
set(bodies "")
foreach(test IN LISTS TESTS)
  file(READ ${FOLDER}/${test} text)
  string(REGEX MATCHALL "#include [^\n]*" lines "${text}")
  list(APPEND includes ${lines})
  string(REGEX REPLACE "#include [^\n]*" "" text "${text}")
  if(PREFIX)
    string(REGEX REPLACE "/.*" "" folder "${test}")
    string(REGEX REPLACE "(TEST_CASE\\([ \n]*\")" "\\1${folder}/" text "${text}")
  endif()
  string(MAKE_C_IDENTIFIER "${test}" name)
  string(APPEND bodies "namespace ${name} {\n#line 1 \"${FOLDER}/${test}\"\n${text}}\n")
endforeach()
list(REMOVE_DUPLICATES includes)
list(JOIN includes "\n" includes)
file(WRITE ${UNIT} "${includes}\n${bodies}")
