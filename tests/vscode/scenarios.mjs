// In this order: later ones use the workspace as earlier ones leave it.
import { scenarios as editing } from './scenario_editing.mjs';
import { scenarios as trust } from './scenario_trust.mjs';

export const scenarios = { ...trust, ...editing };
