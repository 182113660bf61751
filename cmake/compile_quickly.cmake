# What is compiled quickly because it runs but shortly?
#
# Tests, and code that mostly includes large headers of others (JSON, CLI11): compiling it takes
# minutes at full optimisation, which nobody would notice when it runs. With the sanitizers even
# twice as long.
function(vandplan_compile_quickly target)
  target_compile_options(${target} PRIVATE $<IF:$<CONFIG:Debug>,-O0,-O1>)
endfunction()
