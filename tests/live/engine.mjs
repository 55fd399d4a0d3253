// The engine of live.html without a browser.

import { readFileSync } from 'node:fs';
import { gunzipSync } from 'node:zlib';

const page = readFileSync(process.env.LIVE, 'utf8');
const textOf = (id) => page.match(new RegExp(`id="${id}">([^<]*(?:<(?!/script>)[^<]*)*)</script>`))[1];
class NoChannel { port1 = {}; port2 = {}; }  // an open one would keep Node.js running
const engines = new Function('self', 'MessageChannel', `${textOf('worker')}; return engines;`)({}, NoChannel);
const unpacked = (id) => gunzipSync(Buffer.from(textOf(id), 'base64'));
const parts = { module: new WebAssembly.Module(unpacked('engine')), fused: unpacked('fused'), relaxed: unpacked('fused-relaxed') };

export const newEngine = (others = {}) => new engines.Engine({ ...parts, ...others });

/// Runs an experiment in one engine, and counts in another one as the page does. The last argument takes the time [s].
export function run(text, onTime = () => {}) {
  const simulating = newEngine(), counting = newEngine();
  counting.begin(text);
  const facts = simulating.begin(text);
  const began = performance.now();
  let next = 0;
  const done = [];
  do {
    for (; next < facts.realisations && simulating.wantsMore(); next += 2) simulating.start(next);
    const bytes = simulating.work();
    if (bytes) done.push(bytes);
  } while (!simulating.isIdle() || next < facts.realisations);
  onTime((performance.now() - began) / 1000);
  for (const bytes of done) counting.count(bytes);
  return { facts, result: counting.result(), engine: counting };
}
