// A slider of a lesson chooses among pictures that were drawn beforehand; the others go back to their first value.
for (const figure of document.querySelectorAll("figure.sliders")) {
  const sliders = [...figure.querySelectorAll("input")];
  const tell = (slider) => (slider.nextElementSibling.textContent = slider.dataset.values.split(" ")[slider.value]);
  for (const slider of sliders) {
    const pictures = slider.dataset.pictures.split(" ");
    slider.addEventListener("input", () => {
      for (const other of sliders) if (other !== slider) other.value = other.dataset.first;
      sliders.forEach(tell);
      figure.querySelector("img").src = pictures[slider.value];
    });
  }
}
