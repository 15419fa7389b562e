"""Whose fault a wrong picture is: the shader's source, who compiles it, how it is drawn, or what it is given."""
