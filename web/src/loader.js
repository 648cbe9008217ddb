// Unpacks the program, which is deflated and in base64, and runs it.
const program = document.getElementById('program'), packed = Uint8Array.from(atob(program.textContent), (letter) => letter.charCodeAt(0));
const unpacked = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
new Response(unpacked).text().then((text) => program.replaceWith(Object.assign(document.createElement('script'), { textContent: text })));
