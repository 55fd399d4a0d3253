// The engine of live.html gives the bits of the program: 600 realisations of the headline scene.

import assert from 'node:assert/strict';
import { describe, it } from 'node:test';

import { newEngine, run } from './engine.mjs';
import { chaotic, headlines, reportOf } from './scenes.mjs';

describe('the engine as WebAssembly', () => {
  for (const text of [...headlines, chaotic]) {
    it(`has the digests, counts and intervals of the program at ${text.match(/"amplitude":[0-9.]+/)[0]}`, () => {
      const report = reportOf(text);
      const { facts, result } = run(text, (seconds) => console.log(`${seconds.toFixed(2)} s`));
      assert.equal(facts.sha256, report.input.sha256);
      assert.equal(result.digest, report.result.digest);
      assert.deepEqual(facts.experiment, report.input.experiment);
      const { counts, probabilities } = report.result.conditions[0];
      for (const { name, count, interval } of result.modes) {
        assert.equal(count, counts[name], name);
        // Boost.Math computes in long double there, and in double here.
        probabilities[name].simultaneous.forEach((end, i) => assert.ok(Math.abs(end - interval[i]) < 1e-12, `${name}: ${end}, ${interval[i]}`));
      }
      assert.equal(result.modes.reduce((sum, mode) => sum + mode.count, 0), facts.realisations);
    });
  }

  it('shows a realisation of each response mode, with all of its strobe points', () => {
    const { result, engine } = run(headlines[0]);
    for (const { name, numbers } of result.modes) {
      const shown = engine.motion(numbers[0]);
      assert.equal(shown.mode, name);
      assert.equal(shown.strobe.length, 100);
      assert.ok(shown.motion.times.length > 100);
    }
  });

  it('takes no multiply-add that rounds twice', () => {
    const twice = Uint8Array.from([0, 97, 115, 109, 1, 0, 0, 0, 1, 8, 1, 96, 3, 124, 124, 124, 1, 124, 3, 2, 1, 0, 7, 9, 1, 5,
      102, 117, 115, 101, 100, 0, 0, 10, 12, 1, 10, 0, 32, 0, 32, 1, 162, 32, 2, 160, 11]);
    assert.equal(new WebAssembly.Instance(new WebAssembly.Module(twice)).exports.fused(1 / 3, 3, -1), 0);
    for (const relaxed of [twice, new Uint8Array(8)]) {
      assert.equal(newEngine({ relaxed }).fused(1 / 3, 3, -1), -(2 ** -54));
    }
  });

  it('says what is wrong with an experiment', () => {
    assert.throws(() => newEngine().begin(headlines[0].replace('"width_m":1', '"width_m":-1')), /block\/width_m = -1/);
    assert.throws(() => newEngine().begin('{'), /line 1/);
    assert.throws(() => newEngine().begin(headlines[0].replace('{', '{"sweep":[],')), /sweep/);
  });
});
