# How do files become constants of the program?
#
# cmake -DOUTPUT=X.cpp -DHEADER="evaluation/page.h" -DNAMESPACE=vandplan::page
#       -DNAMES=html,css -DFILES=a.html,b.css -P embed.cmake
string(REPLACE "," ";" NAMES "${NAMES}")
string(REPLACE "," ";" FILES "${FILES}")
set(code "#include \"${HEADER}\"\n\nnamespace ${NAMESPACE} {\n")
foreach(name file IN ZIP_LISTS NAMES FILES)
  file(READ "${file}" hex HEX)
  string(REGEX REPLACE "(..)" "0x\\1," bytes "${hex}")
  string(APPEND code "namespace {\nconstexpr unsigned char ${name}_bytes[] = {${bytes}0};\n}\n"
         "const std::string_view ${name}(reinterpret_cast<const char*>(${name}_bytes), sizeof ${name}_bytes - 1);\n")
endforeach()
file(WRITE "${OUTPUT}" "${code}}  // namespace ${NAMESPACE}\n")
