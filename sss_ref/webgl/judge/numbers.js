// Numbers as they lie between others of their type, and as text.

const scratch = new DataView(new ArrayBuffer(4));

// A number as an integer, in the same order and without gaps; of a float its bits, -0 and 0 as one.
function ordered(number, kind) {
  if (kind !== "float") return number;
  scratch.setFloat32(0, number);
  const bits = scratch.getInt32(0);
  return bits < 0 ? -0x80000000 - bits : bits;
}

// The number that an integer stands for.
function numberAt(place, kind) {
  if (kind !== "float") return place;
  scratch.setInt32(0, place < 0 ? -0x80000000 - place : place);
  return scratch.getFloat32(0);
}

// The shortest text that is read back as the same float32.
function textOf(number) {
  if (!Number.isFinite(number)) return String(number).replace("Infinity", "infinity");
  for (let digits = 1; digits < 9; digits++) {
    const text = number.toPrecision(digits);
    if (Math.fround(Number(text)) === Math.fround(number)) return String(Number(text));
  }
  return String(Number(number.toPrecision(9)));
}

function tupleText(numbers) {
  return numbers.length === 1 ? textOf(numbers[0]) : `(${numbers.map(textOf).join(", ")})`;
}

// An interval in words.
function intervalText([low, high]) {
  if (low === high) return textOf(low);
  if (low === -Infinity && high === Infinity) return "anything";
  return low > high ? "nothing" : `${textOf(low)} to ${textOf(high)}`;
}
