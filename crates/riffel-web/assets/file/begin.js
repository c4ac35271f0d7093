// The first script of the page that is one file: unpacks its parts and lets the modules find each other.

{
  const text = (id) => document.getElementById(id).textContent;
  const url = (content, type) => URL.createObjectURL(new Blob([content], { type }));
  const unpack = async (id) => {
    const packed = Uint8Array.from(atob(text(id)), (letter) => letter.charCodeAt(0));
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
    return new Response(stream).arrayBuffer();
  };
  const modules = [...document.querySelectorAll('script[data-module]')];
  const imports = Object.fromEntries(modules.map((node) => [`riffel/${node.dataset.module}`, url(node.textContent, 'text/javascript')]));
  document.head.append(Object.assign(document.createElement('script'), { type: 'importmap', textContent: JSON.stringify({ imports }) }));
  window.riffelParts = { module: unpack('riffel-wasm') };
  // plotly.js is asked for when the first curve is drawn.
  unpack('plotly').then((script) => {
    document.querySelector('meta[name=plotly]').content = url(script, 'text/javascript');
    document.head.append(Object.assign(document.createElement('script'), { type: 'module', textContent: "import 'riffel/main.js';" }));
  });
}
