# Writes OUTPUT, which defines headland::program_version(): VERSION and a digest of the sources in ROOMS
# of SOURCE_DIR. Called by the build whenever one of them changes.
set(digests "")
foreach(room IN LISTS ROOMS)
  file(GLOB sources ${SOURCE_DIR}/${room}/*.cpp ${SOURCE_DIR}/${room}/*.h
       ${SOURCE_DIR}/${room}/algorithms/*.cpp ${SOURCE_DIR}/${room}/algorithms/*.h)
  list(SORT sources)
  foreach(source IN LISTS sources)
    file(SHA256 ${source} digest)
    file(RELATIVE_PATH name ${SOURCE_DIR} ${source})
    string(APPEND digests "${name} ${digest}\n")
  endforeach()
endforeach()
string(SHA256 digest "${digests}")
string(SUBSTRING ${digest} 0 12 digest)
file(WRITE ${OUTPUT}
     "#include \"evaluate/program_version.h\"\n\nnamespace headland {\n\n"
     "std::string_view program_version() { return \"${VERSION}+${digest}\"; }\n\n}  // namespace headland\n")
