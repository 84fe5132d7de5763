# layoutbox_embed(TARGET NAME file…): compiles the files into TARGET as std::string_view constants, declared in the generated header
# "layoutbox/embedded/NAME.h" in namespace layoutbox::embedded, one per file: catalog/rooms.json → rooms_json; and all of them with their names: NAME_files().
function(layoutbox_embed target name)
  set(folder ${CMAKE_BINARY_DIR}/embedded/layoutbox/embedded)
  set(output ${folder}/${name}.h ${folder}/${name}.cc)
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DNAME=${name} -DFOLDER=${folder} "-DFILES=${ARGN}" -P ${PROJECT_SOURCE_DIR}/cmake/embed_files.cmake
    DEPENDS ${ARGN} ${PROJECT_SOURCE_DIR}/cmake/embed_files.cmake
    COMMENT "Embedding ${name}" VERBATIM)
  target_sources(${target} PRIVATE ${output})
  # By itself: no compiler cache knows what the assembler reads.
  set_source_files_properties(${folder}/${name}.cc PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  target_include_directories(${target} PUBLIC ${CMAKE_BINARY_DIR}/embedded)
endfunction()
