# Writes OUT, the commit that the tree at SOURCE was built from ("+" behind it where files were changed since), and
# touches it only where that is new. Run at each build, since a commit changes no source.
find_program(GIT git)
set(commit "")
if(GIT)
  execute_process(COMMAND ${GIT} -C ${SOURCE} describe --always --abbrev=12 --exclude=* --dirty=+
    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
set(text "#include \"results/file/provenance.hpp\"\n\nnamespace trilith::results {\nconst char* built_from() {\n  return \"${commit}\";\n}\n}  // namespace trilith::results\n")
set(there "")
if(EXISTS ${OUT})
  file(READ ${OUT} there)
endif()
if(NOT there STREQUAL text)
  file(WRITE ${OUT} "${text}")
endif()
