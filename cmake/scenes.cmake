# The shipped scenes' geometry is written by our own generator at build time into scenes/geometry (not tracked).
