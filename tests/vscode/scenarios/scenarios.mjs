// In this order: later scenarios use the workspace as earlier ones leave it.
import { scenarios as automaton } from './automaton.mjs';
import { scenarios as copies } from './copies.mjs';
import { scenarios as debugging } from './debugger.mjs';
import { scenarios as disk } from './disk.mjs';
import { scenarios as editing } from './editing.mjs';
import { scenarios as first } from './first.mjs';
import { scenarios as folders } from './folders.mjs';
import { scenarios as imports } from './imports.mjs';
import { scenarios as large } from './large.mjs';
import { scenarios as lenses } from './lenses.mjs';
import { scenarios as mission } from './mission.mjs';
import { scenarios as olderText } from './older_text.mjs';
import { scenarios as opening } from './opening.mjs';
import { scenarios as picture } from './picture.mjs';
import { scenarios as pictures } from './pictures.mjs';
import { scenarios as secondDay } from './second_day.mjs';
import { scenarios as simulation } from './simulation.mjs';
import { scenarios as testing } from './testing.mjs';
import { scenarios as traces } from './traces.mjs';
import { scenarios as trust } from './trust.mjs';
import { scenarios as typing } from './typing.mjs';
import { scenarios as verification } from './verification.mjs';
import { scenarios as walkthrough } from './walkthrough.mjs';

export const scenarios = {
  ...trust, ...editing, ...automaton, ...picture, ...verification, ...testing, ...traces, ...opening, ...lenses, ...typing, ...imports, ...large, ...simulation, ...mission, ...secondDay, ...folders, ...copies, ...olderText, ...disk, ...first, ...debugging, ...walkthrough, ...pictures,
};
