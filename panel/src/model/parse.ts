import type { Location, Program, Step, Trace, Verdict } from '../api.ts';

/** Contents of a file or a report. */
export interface Opened {
  traces: Trace[];
  /** of a whole report */
  program: Program | null;
}

type Json = { [key: string]: unknown };
const isObject = (value: unknown): value is Json => typeof value === 'object' && value !== null && !Array.isArray(value);

/** `docs/verify.schema.json` counts from 1 and uses paths; the interface counts from 0. */
export function locationOf(value: unknown): Location | null {
  if (!isObject(value)) return null;
  if (isObject(value['range']) && typeof value['uri'] === 'string') return value as unknown as Location;
  const { file, begin, end } = value as { file?: unknown; begin?: Json; end?: Json };
  if (typeof file !== 'string' || !isObject(begin) || !isObject(end)) return null;
  const at = (place: Json) => ({ line: Number(place['line']) - 1, character: Number(place['column']) - 1 });
  return { uri: file, range: { start: at(begin), end: at(end) } };
}

export function stepOf(value: unknown, index: number): Step {
  if (!isObject(value) || typeof value['actor'] !== 'string' || !isObject(value['date']) || !isObject(value['earliest']))
    throw new Error(`step ${index + 1} is not one of a trace`);
  const message = value['message'];
  return {
    changes: [], transitions: [], ...value,
    ...(typeof message === 'string' && { description: `prints "${message}"` }),
    location: locationOf(value['location']),
  } as unknown as Step;
}

export function traceOf(value: Json, about: Json = value): Trace {
  if (!Array.isArray(value['steps']) || !isObject(value['initial'])) throw new Error('it has no steps, or no initial values');
  const text = (key: string): string => (typeof about[key] === 'string' ? (about[key] as string) : '');
  const trace: Trace = {
    name: text('name'),
    description: text('description') || text('name'),
    verdict: text('verdict'),
    initial: value['initial'] as Trace['initial'],
    steps: value['steps'].map(stepOf),
  };
  if (Array.isArray(value['actors'])) trace.actors = value['actors'] as NonNullable<Trace['actors']>;
  if (typeof value['summary'] === 'string') trace.summary = value['summary'];
  if (typeof value['loop'] === 'number') trace.loop = value['loop'];
  if (isObject(value['sources'])) trace.sources = value['sources'] as NonNullable<Trace['sources']>;
  if (value['stale'] === true) trace.stale = true;
  if (isObject(value['part'])) trace.part = value['part'] as unknown as NonNullable<Trace['part']>;
  return trace;
}

const stepsOf = (property: Json): number | null => (typeof property['steps'] === 'number' ? property['steps'] : null);

function verdictOf(property: Json): Verdict {
  const trace = property['trace'];
  return {
    ...(property as unknown as Verdict),
    location: locationOf(property['location']),
    reason: typeof property['reason'] === 'string' ? property['reason'] : '',
    steps: isObject(trace) && Array.isArray(trace['steps']) ? trace['steps'].length : stepsOf(property),
  };
}

const baseName = (path: string): string => path.split(/[\\/]/).at(-1) || path;

/** A report of `proskill verify --format json`. */
function reportOf(report: Json): Opened {
  const properties = (report['properties'] as unknown[]).filter(isObject);
  const traces = properties
    .filter((property) => isObject(property['trace']))
    .map((property) => traceOf(property['trace'] as Json, property));
  const name = String(report['program'] ?? '');
  const program: Program = {
    program: name,
    label: baseName(name),
    main: typeof report['main'] === 'string' ? report['main'] : null,
    state: 'done',
    stale: false,
    message: '',
    progress: null,
    verdicts: properties.map(verdictOf),
    exploration: (report['exploration'] ?? null) as Program['exploration'],
    pictures: [],
    files: [],
  };
  return { traces, program };
}

/** Reads a report, a trace saved by `--save-traces`, or one that the panel exported. */
export function open(text: string): Opened {
  let value: unknown;
  try {
    value = JSON.parse(text);
  } catch {
    throw new Error('not valid JSON');
  }
  if (!isObject(value)) throw new Error('this is neither a report nor a trace');
  if (Array.isArray(value['properties'])) return reportOf(value);
  if (Array.isArray(value['steps'])) return { traces: [traceOf(value)], program: null };
  throw new Error('this is neither a report nor a trace');
}
