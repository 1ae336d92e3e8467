// Decodes the data of the page: gzip and base64 around JSON and blocks of integers (engine/view/bytes.hpp).

/** Bytes of base64 text. */
function bytesOf(text) {
  const letters = atob(text.trim());
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; i++) bytes[i] = letters.charCodeAt(i);
  return bytes;
}

async function inflate(bytes) {
  if (typeof DecompressionStream === "undefined")
    throw new Error("This browser is too old for this page: it lacks DecompressionStream (Chrome 80, Firefox 113, Safari 16.4).");
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Rows of integers from differences down each column. */
function unpack(bytes, from, rows, columns) {
  const values = new Int32Array(rows * columns);
  let at = from;
  for (let c = 0; c < columns; c++) {
    let value = 0;
    for (let i = c; i < values.length; i += columns) {
      let byte = bytes[at++];
      let number = byte & 127;
      for (let unit = 128; byte > 127; unit *= 128) {
        byte = bytes[at++];
        number += (byte & 127) * unit;
      }
      value += number % 2 === 1 ? -(number + 1) / 2 : number / 2;
      values[i] = value;
    }
  }
  return values;
}

/** Converts the text of the data element to { head, blocks }: blocks[name] = { rows, columns, quantum, values: Int32Array }. */
export async function decode(text) {
  const bytes = await inflate(bytesOf(text));
  const view = new DataView(bytes.buffer);
  const mark = new TextDecoder().decode(bytes.subarray(0, 4));
  if (mark !== "TRLV" || view.getUint32(4, true) !== 1) throw new Error("The data of this page is damaged.");
  const length = view.getUint32(8, true);
  const head = JSON.parse(new TextDecoder().decode(bytes.subarray(12, 12 + length)));
  const blocks = {};
  let at = 12 + length;
  for (const block of head.blocks) {
    blocks[block.name] = { ...block, values: unpack(bytes, at, block.rows, block.columns) };
    at += block.bytes;
  }
  return { head, blocks };
}
