"""A scene as a folder for another renderer: mesh, uniforms, shaders, pass list, porting guide."""
