# Writes LIST, the ctest file with every test case of the doctest program PROGRAM, its suite as a label. The program
# runs once. The script of doctest is not used. It runs the program once more per case, which takes minutes under
# sanitizers, and finds no suite of a case with a comma in its name. usage: cmake -DPROGRAM=... -DLIST=... -P
# discover.cmake
execute_process(COMMAND "${PROGRAM}" --list-test-cases --reporters=xml --no-version
  OUTPUT_VARIABLE xml RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} does not list its test cases: ${result}")
endif()

# attribute(TAG NAME INTO): the unescaped text of an attribute of an XML tag; empty if it is absent.
function(attribute tag name into)
  set(text "")
  if(tag MATCHES " ${name}=\"([^\"]*)\"")
    set(text "${CMAKE_MATCH_1}")
  endif()
  foreach(pair "&lt;=<" "&gt;=>" "&quot;=\"" "&apos;='" "&#91;=[" "&#93;=]" "&amp;=&")
    string(REGEX MATCH "^(&[^=]*)=(.)" whole "${pair}")
    string(REPLACE "${CMAKE_MATCH_1}" "${CMAKE_MATCH_2}" text "${text}")
  endforeach()
  set(${into} "${text}" PARENT_SCOPE)
endfunction()

# Brackets would join the elements of a list.
string(REPLACE "[" "&#91;" xml "${xml}")
string(REPLACE "]" "&#93;" xml "${xml}")
string(REGEX MATCHALL "<TestCase [^\n]*" tags "${xml}")
set(script "")
foreach(tag IN LISTS tags)
  attribute("${tag}" name name)
  attribute("${tag}" testsuite suite)
  # A semicolon would divide the tag, and a case without a name would run all cases.
  if(name STREQUAL "")
    message(FATAL_ERROR "the name of a test case contains one of ; < > & \": ${tag}")
  endif()
  string(REPLACE "," "\\," pattern "${name}")  # a comma would part two patterns
  string(APPEND script "add_test([==[${name}]==] \"${PROGRAM}\" [==[--test-case=${pattern}]==])\n"
    # A name that matches no case would pass without running anything, so it counts as failed. A case that needs a file
    # missing on this machine prints MESSAGE("skipped: ...") and is listed as skipped.
    "set_tests_properties([==[${name}]==] PROPERTIES LABELS \"${suite}\" FAIL_REGULAR_EXPRESSION \"test cases: +0 \" "
    "SKIP_REGULAR_EXPRESSION \"MESSAGE: skipped: \")\n")
endforeach()
file(WRITE "${LIST}" "${script}")
