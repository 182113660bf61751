# Which warnings does every target of ours live with?
add_library(vandplan_warnings INTERFACE)
target_compile_options(
  vandplan_warnings
  INTERFACE -Wall
            -Wextra
            -Wpedantic
            -Wshadow
            -Wconversion
            # Clang's also dislikes double where long double is meant.
            $<$<CXX_COMPILER_ID:GNU>:-Wdouble-promotion>
            # g++ 12 sees overlapping copies in "text" + std::string where there are none (GCC bug 105651).
            $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
            # Kernels join comparisons with & on purpose: no branches.
            $<$<CXX_COMPILER_ID:Clang>:-Wno-bitwise-instead-of-logical>
            $<$<BOOL:${VANDPLAN_WERROR}>:-Werror>)
