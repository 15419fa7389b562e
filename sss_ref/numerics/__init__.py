"""Correctly rounded float32 pow, exp2, log2 and exp: the same bits in array code and in compiled code (rule A2).

`elementary` holds the functions and their array forms (NumPy only), `scalar` their compiled forms.
"""
