# Read by the tests that compile something below a folder $work: the compiler is called by ccache where it is installed,
# and its answers do not depend on the name of that folder.
compiler_cache=$(command -v ccache || true)
export CCACHE_BASEDIR=$work CCACHE_NOHASHDIR=1 CCACHE_SLOPPINESS=time_macros,include_file_mtime,include_file_ctime
