// A worker: holds the program as a module of WebAssembly and answers one question after the other.

let exports;

addEventListener('message', async ({ data: { module, path, body } }) => {
  if (module) {
    // The module imports nothing: it can do nothing but compute.
    try {
      exports = (await WebAssembly.instantiate(module, {})).exports;
      postMessage({ ready: true });
    } catch (fault) {
      postMessage({ broken: String(fault) });
    }
    return;
  }
  const [name, question] = [path, body].map((text) => new TextEncoder().encode(text));
  let status;
  try {
    const place = exports.room(name.length, question.length);
    const room = new Uint8Array(exports.memory.buffer, place, name.length + question.length);
    room.set(name);
    room.set(question, name.length);
    status = exports.answer();
  } catch (fault) {
    // A defect has stopped the program: what is left of it is not to be trusted.
    postMessage({ broken: String(fault) });
    return;
  }
  const answer = new Uint8Array(exports.memory.buffer, exports.reply(), exports.reply_length()).slice();
  postMessage({ status, answer }, [answer.buffer]);
});
