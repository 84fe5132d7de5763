# Warnings are errors, for both compilers.
add_compile_options(-Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Wcast-qual -Wunused
                    -Woverloaded-virtual -Wnull-dereference -Wformat=2 -Werror)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC 12 reports these inside the standard library's own headers when optimising.
  add_compile_options(-Wno-null-dereference -Wno-restrict -Wno-maybe-uninitialized)
  # Clang's warning of this name also means plain conversions, which are wanted.
  add_compile_options(-Wdouble-promotion)
endif()
