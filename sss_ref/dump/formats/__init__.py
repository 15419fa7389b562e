"""One file format of dumps a file."""
