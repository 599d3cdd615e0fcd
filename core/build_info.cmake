# Writes `output` from `template`; run at build time by the target talus_build_info.
set(git_commit "release ${version}")
set(git_dirty false)
set(git_diff "")
set(longest 60000)  # bytes; compilers need not take literals beyond 65536

find_program(GIT git)
if(GIT AND EXISTS ${source}/.git)
  execute_process(COMMAND ${GIT} -C ${source} rev-parse HEAD
    OUTPUT_VARIABLE commit RESULT_VARIABLE failed OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(NOT failed)
    set(git_commit ${commit})
    execute_process(COMMAND ${GIT} -C ${source} status --porcelain OUTPUT_VARIABLE changes ERROR_QUIET)
    execute_process(COMMAND ${GIT} -C ${source} diff --no-ext-diff --no-color HEAD
      OUTPUT_VARIABLE git_diff ERROR_QUIET)
    if(changes)
      set(git_dirty true)
    endif()
    string(LENGTH "${git_diff}" length)
    if(length GREATER longest)
      string(SUBSTRING "${git_diff}" 0 ${longest} git_diff)
      string(FIND "${git_diff}" "\n" last REVERSE)  # a whole line, so that no character is cut in two
      string(SUBSTRING "${git_diff}" 0 ${last} git_diff)
      string(APPEND git_diff "\n... the first lines of ${length} bytes")
    endif()
  endif()
endif()

# The diff may hold any text; its own hash is a bracket that it cannot.
string(MD5 bracket "${git_diff}")
string(SUBSTRING ${bracket} 0 16 bracket)
configure_file(${template} ${output} @ONLY)
