"""Correctly rounded float32 pow, exp2, log2 and exp, and intervals of what a processor may compute.

`elementary` holds the functions and their array forms (NumPy only), `scalar` their compiled forms: the same bits in
array code and in compiled code (rule A2). `interval` holds sets of values, `arithmetic` what operations make of them.
`random_numbers` holds numbers that no machine, version or number of threads changes.
"""
