// How questions reach the program in the page that is one file: workers hold it, so that the page stays fluid.

/** Workers at a time: one for each processor, but a page seldom asks more than these at once. */
const MOST = Math.min(navigator.hardwareConcurrency || 2, 4);
/** How long work that nobody waits for any more may go on before its worker is ended [ms]: most work ends sooner, and what a worker knows of contacts goes with it. */
const GRACE = 300;

const text = (id) => document.getElementById(id).textContent;

/** The case that lies inside the page. */
export const inside = JSON.parse(text('case-inside'));

const workerUrl = URL.createObjectURL(new Blob([text('worker')], { type: 'text/javascript' }));
const compiled = window.riffelParts.module.then((bytes) => WebAssembly.compile(bytes));

/** Every worker with the work that it does; null for one that waits. */
const workers = new Map();
const waiting = [];

/** A worker that can answer; it does the first work when the module stands. */
async function begin(first) {
  const worker = new Worker(workerUrl);
  workers.set(worker, first);
  worker.onmessage = ({ data }) => {
    if (data.ready) return give(worker, workers.get(worker));
    const done = workers.get(worker);
    if (data.broken) end(worker, { message: 'the computation broke off', help: data.broken });
    else {
      done.resolve(new Response(data.answer, { status: data.status }));
      next(worker);
    }
    return undefined;
  };
  worker.onerror = ({ message }) => end(worker, { message: 'the computation broke off', help: message });
  try {
    worker.postMessage({ module: await compiled });
  } catch (fault) {
    end(worker, { message: 'this browser cannot run the program inside the page', help: String(fault) });
  }
}

function give(worker, work) {
  if (!work) return;
  // Nobody may want it any more.
  if (work.signal?.aborted) next(worker);
  else worker.postMessage({ path: work.path, body: work.body });
}

/** The worker is free. */
function next(worker) {
  const work = waiting.shift() ?? null;
  workers.set(worker, work);
  give(worker, work);
}

/** End a worker, and answer what it did with a fault. */
function end(worker, fault) {
  workers.get(worker)?.resolve(new Response(JSON.stringify(fault), { status: 500 }));
  worker.terminate();
  workers.delete(worker);
  if (waiting.length) begin(waiting.shift());
}

/** A question, and the Response to it: what `fetch` is to the page that is served. */
export function reach(path, { body = '', signal } = {}) {
  if (path === '/api/vocabulary') return Promise.resolve(new Response(text('vocabulary')));
  return new Promise((resolve, reject) => {
    signal?.throwIfAborted();
    const work = { path, body, signal, resolve };
    signal?.addEventListener('abort', () => {
      reject(signal.reason);
      const at = waiting.indexOf(work);
      if (at >= 0) waiting.splice(at, 1);
      const does = () => [...workers].find(([, own]) => own === work)?.[0];
      if (does()) setTimeout(() => does() && end(does(), {}), GRACE);
    });
    const [free] = [...workers].find(([, own]) => own === null) ?? [];
    if (free) {
      workers.set(free, work);
      give(free, work);
    } else if (workers.size < MOST) begin(work);
    else waiting.push(work);
  });
}
