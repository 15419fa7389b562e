// Several pictures beside each other are scrolled on a phone, where they would shrink to stamps.
const mark = (image) => image.classList.toggle("row", image.naturalWidth > 2.05 * image.naturalHeight);
for (const image of document.querySelectorAll(".cell_output img")) {
  if (image.complete) mark(image);
  else image.addEventListener("load", () => mark(image));
}
