-- Rules for the Lua of the project: Lua 5.4, no stray globals, lines as long as in the C++.
std = "lua54"
max_line_length = 120
