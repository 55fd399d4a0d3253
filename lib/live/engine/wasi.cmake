# WebAssembly with Debian's clang 19 and the C and C++ libraries for WASI.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_CXX_COMPILER clang++-19)
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
set(CMAKE_BUILD_TYPE MinSizeRel)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
