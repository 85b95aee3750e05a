// In this order: later ones use the workspace as earlier ones leave it.
import { scenarios as automaton } from './scenario_automaton.mjs';
import { scenarios as debugging } from './scenario_debugger.mjs';
import { scenarios as editing } from './scenario_editing.mjs';
import { scenarios as picture } from './scenario_picture.mjs';
import { scenarios as testing } from './scenario_testing.mjs';
import { scenarios as traces } from './scenario_traces.mjs';
import { scenarios as trust } from './scenario_trust.mjs';
import { scenarios as typing } from './scenario_typing.mjs';
import { scenarios as verification } from './scenario_verification.mjs';
import { scenarios as walkthrough } from './scenario_walkthrough.mjs';

export const scenarios = {
  ...trust, ...editing, ...automaton, ...picture, ...verification, ...testing, ...traces, ...typing, ...debugging, ...walkthrough,
};
