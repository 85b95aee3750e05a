// In this order: later ones use the workspace as earlier ones leave it.
import { execFileSync } from 'node:child_process';
import { scenarios as automaton } from './scenario_automaton.mjs';
import { scenarios as debugging } from './scenario_debugger.mjs';
import { scenarios as editing } from './scenario_editing.mjs';
import { scenarios as trust } from './scenario_trust.mjs';
import { scenarios as verification } from './scenario_verification.mjs';

/** To go when `proskill dap`, and the server's requests that came with it, are in the tree. */
const whole = /^ +dap\b/m.test(execFileSync(process.argv[2], ['--help'], { encoding: 'utf8' }));
if (!whole) console.log('left out: automata, verification, traces, debugger; this proskill has no `dap`');

export const scenarios = { ...trust, ...editing, ...(whole && { ...automaton, ...verification, ...debugging }) };
