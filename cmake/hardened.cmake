# Flags of packages: an overrun buffer or a damaged return address ends the program, and its code, tables and stack are where
# no attacker expects or can write them. Compilers add _FORTIFY_SOURCE of a distribution; ours replaces it. It needs optimisation.
# Checked functions come with warnings of their own, which are errors in no package.
include(CheckPIESupported)
check_pie_supported(LANGUAGES CXX)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)  # with the check: programs are linked as -pie
add_compile_options($<$<NOT:$<CONFIG:Debug>>:-U_FORTIFY_SOURCE> $<$<NOT:$<CONFIG:Debug>>:-D_FORTIFY_SOURCE=3>
  -fstack-protector-strong -fstack-clash-protection)
add_link_options(-Wl,-z,relro -Wl,-z,now -Wl,-z,noexecstack)
