# Files as bytes in a C++ source. Run as a script:
#   cmake -D OUT=FILE.cpp -D FILES=a.js;b.css -D NAMESPACE=n -D HEADER=h -P Embed.cmake
# Each file becomes `const std::string_view NAME`, its name in lowerCamel: panel.js is panelJs.
set(text "#include \"${HEADER}\"\n\nnamespace ${NAMESPACE} {\n\nnamespace {\n")
set(views "")
foreach(file IN LISTS FILES)
  get_filename_component(base ${file} NAME)
  string(REGEX MATCH "^(.*)\\.([a-z])(.*)$" matched ${base})
  string(TOUPPER ${CMAKE_MATCH_2} letter)
  set(name "${CMAKE_MATCH_1}${letter}${CMAKE_MATCH_3}")
  file(READ ${file} hex HEX)
  string(LENGTH "${hex}" length)
  math(EXPR length "${length} / 2")
  string(REGEX REPLACE "(................................)" "\\1\n" hex "${hex}")
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "'\\\\x\\1'," hex "${hex}")
  string(APPEND text "constexpr char k_${name}[] = {\n${hex}};\n")
  string(APPEND views "const std::string_view ${name}(k_${name}, ${length});\n")
endforeach()
file(WRITE ${OUT} "${text}\n} // namespace\n\n${views}\n} // namespace ${NAMESPACE}\n")
