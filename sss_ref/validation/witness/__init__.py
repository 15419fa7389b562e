"""A wrong pixel cut down to one stage: a small file that can be judged, and run on a GPU, by itself."""
