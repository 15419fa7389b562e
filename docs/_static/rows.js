// Several pictures beside each other are scrolled on a phone, where they would shrink to stamps; what scrolls says so.
const mark = (image) => image.classList.toggle("row", image.naturalWidth > 2.05 * image.naturalHeight);
for (const image of document.querySelectorAll(".cell_output img")) {
  if (image.complete) mark(image);
  else image.addEventListener("load", () => mark(image));
}
const boxes = document.querySelectorAll(".cell_output, .table-wrapper, div.math");
const tell = () => boxes.forEach((box) => box.classList.toggle("scrolls", box.scrollWidth > box.clientWidth + 1));
new ResizeObserver(tell).observe(document.body); // pictures and formulas come later, and make the page longer
