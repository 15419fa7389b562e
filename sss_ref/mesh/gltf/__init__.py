"""glTF 2.0 and GLB files, read by the specification (Khronos, glTF 2.0, registry version 2.0.1).

`gltf_file` opens a file; `gltf_document` checks entries of its JSON as they are used; `gltf_buffers` and `accessors`
give the numbers, `hierarchy` the nodes in order and their transforms; `gltf_primitives` makes triangles, `morphs`,
`skins` and `instances` put them where they are at rest; `gltf_reader` is the way through all of them.
"""
