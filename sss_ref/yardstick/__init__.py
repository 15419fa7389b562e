"""How far each technique is from the truth: the same camera, light and medium, in the same units.

`yardstick` says what is held against what, `rungs` renders the techniques, `regions` says where on the body a pixel
lies, `deviation` how far off it is; `ladder` puts them together, and the rest of the room tells it: as a record, a
table, pictures and a page.
"""
