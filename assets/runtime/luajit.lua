-- ---- LuaJIT ----

-- Its own limits are too small for a world: it would throw its machine code away again and again, and be slower than
-- without compiling. A game may choose other options after it has loaded this file.
if rawget(_G, "jit") and jit.opt then jit.opt.start("maxmcode=65536", "maxtrace=10000") end
