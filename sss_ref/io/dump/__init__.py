"""Reading what a GPU wrote: one file per buffer, in whatever format, brought into the form of our own buffers."""
