# Warnings are errors, for both compilers. (Clang's -Wdouble-promotion also means plain conversions, which are wanted.)
add_compile_options(-Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Wcast-qual -Wunused
                    -Woverloaded-virtual -Wnull-dereference $<$<CXX_COMPILER_ID:GNU>:-Wdouble-promotion> -Wformat=2 -Werror)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC 12 reports these inside the standard library's own headers when optimising.
  add_compile_options(-Wno-null-dereference -Wno-restrict -Wno-maybe-uninitialized)
endif()
