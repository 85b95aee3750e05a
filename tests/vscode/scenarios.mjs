export { scenarios } from './scenario_editing.mjs';
