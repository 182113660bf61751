# What is compiled quickly because it runs but shortly?
#
# Tests, and code that mostly includes large headers of others (JSON, CLI11): compiling it takes
# minutes at full optimisation, which nobody would notice when it runs: at -O1, or at the level named. Builds with sanitizers stay
# at the -O1 of their presets: without any optimisation JSON takes minutes there.
function(vandplan_compile_quickly target)
  set(level -O1)
  if(ARGC GREATER 1)
    set(level ${ARGV1})
  endif()
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:${level}>)
endfunction()
