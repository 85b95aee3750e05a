import type { Program } from '../api.ts';
import { plural } from './dom.ts';

function progressWords({ decided, total, classes, rate, bytes, seconds }: NonNullable<Program['progress']>): string {
  const much = `${plural(classes, 'class', 'classes')}, ${Math.round(rate).toLocaleString('en')} a second, ${Math.round(bytes / 1e6)} MB`;
  return `decided ${decided} of ${plural(total, 'property', 'properties')}; ${much}, ${Math.round(seconds)} s`;
}

/** Describes how far the verification of a program is. */
export function stateWords(program: Program): string {
  const { progress, exploration } = program;
  switch (program.state) {
    case 'waiting': return 'waiting for an idle moment';
    case 'checking':
      return progress ? `verifying: ${progressWords(progress)}` : 'verifying';
    case 'errors': return program.message || 'the text has errors';
    case 'failed': return program.message || 'the verification failed';
    case 'off': return program.message || 'not verified';
    case 'done': {
      if (!exploration) return '';
      const much = `${plural(exploration.classes, 'class', 'classes')} in ${exploration.seconds.toFixed(2)} s`;
      return exploration.complete ? much : `${much}, then stopped: ${exploration.stopped}`;
    }
  }
}
