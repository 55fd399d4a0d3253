// Experiments that the page and the program compute, with what the program has found.

import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

/// The headline scene at three amplitudes, 200 realisations each.
const headline = (amplitude, fluctuation) => ({
  format: 'rocking.experiment/1', block: { width_m: 1, height_m: 4 },
  excitation: { amplitude, frequency_ratio: 10 }, friction: { static: 0.4, kinetic: 0.35 },
  fluctuation: { friction: fluctuation }, horizon: { transient_periods: 40, sampled_periods: 60 },
  realisations: 200, seed: '0x2012' });

export const headlines = [headline(4, { sigma: 0.03, correlation: 1 }), headline(4.2, { sigma: 0.03, refreshes_per_period: 200 }),
  headline(2, { sigma: 0.03, correlation: 1 })].map((each) => JSON.stringify(each));
/// Most of its responses need Lyapunov exponents, which take thirty times as long.
export const chaotic = JSON.stringify({ ...headline(5.5, { sigma: 0.03, refreshes_per_period: 200 }), realisations: 10 });

/// report.json of a run of the program.
export function reportOf(text) {
  const folder = mkdtempSync(join(tmpdir(), 'rocking-live-'));
  try {
    writeFileSync(join(folder, 'live.json'), text);
    execFileSync(process.env.ROCKING, ['run', join(folder, 'live.json'), '-o', join(folder, 'out'), '--no-page', '-q']);
    return JSON.parse(readFileSync(join(folder, 'out', 'report.json'), 'utf8'));
  } finally {
    rmSync(folder, { recursive: true });
  }
}
