"""The stages of the paper, one file for each of its nouns. Read them beside the paper, in the order of the light's way.

1. `vertex`: where the mesh lies in the light's picture, the camera's, and the UV layout.
2. `shadow_map`: how far the light travels to the first surface; where it entered the body and how thick that is there.
3. `camera`: the surface that a pixel shows.
4. `surface_detail`: the same surface with finer normals and a highlight of its own, from pictures over it.
5. `phong`: how that surface reflects the light.
6. `translucency`: how much light comes through the body, and how it joins what is reflected; `transmittance`: the same
   for light that goes round to the lit side. `soft_shadow`: both with the soft edge of a shadow.
7. `seen_through`: how much of a body inside the mesh is seen, and how much light gets there.
8. `blur`: how light that scatters below the surface leaves beside where it entered (Table 1). Where its offsets are in
   mm, `lengths` says what these are in pixels, and `blur_on_surface` keeps it from what lies far behind. Other
   techniques have other blurs in its place: `separable_blur`, `burley_blur`; `preintegrated_skin` has a table instead.
9. `composite`: the picture.

Texture space (paper 2.2, 3.3) has two files more, and what it shares it takes from above:

10. `irradiance`: the light that arrives, laid out flat by UV.
11. `texture_image`: the picture from the blurred layout; `gaussian_blur`: from six blurs of it, one after the other.

`light_sum` adds several lights. Two tables name what passes from stage to stage: `buffers`, what is written, and
`light_uniforms`, what each light has for itself. Which stages follow each other is said in `sss_ref.methods`.
"""
