# What is compiled quickly because it runs but shortly?
#
# Tests, and code that mostly includes large headers of others (JSON, CLI11): compiling it takes
# minutes at full optimisation, which nobody would notice when it runs. Builds with sanitizers stay
# at the -O1 of their presets: without any optimisation JSON takes minutes there.
function(vandplan_compile_quickly target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()
