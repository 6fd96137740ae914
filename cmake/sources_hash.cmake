# cmake -DNAME=MACRO -DOUTPUT=FILE -DBUILD=TEXT -DROOT=FOLDER -DSOURCES=LIST -P sources_hash.cmake: a header with a hash of sources, and of how they are compiled.
set(hashes "${BUILD}")
foreach(source ${SOURCES})
  file(SHA256 ${ROOT}/${source} hash)
  string(APPEND hashes "\n${source} ${hash}")
endforeach()
string(SHA256 hash "${hashes}")
file(WRITE ${OUTPUT} "#define ${NAME} \"${hash}\"\n")
