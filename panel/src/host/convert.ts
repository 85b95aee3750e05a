import type { Hello, Method, Picture, Program, RunSteps, Simulation, Trace } from '../api.ts';
import { locationOf, open, stepOf, traceOf } from '../model/parse.ts';
import { pictureOf } from './pictures.ts';

/** The server's programs are reports in the form of docs/verify.schema.json, with more members. */
export function programOf(value: unknown): Program {
  const { program } = open(JSON.stringify(value));
  return { ...program!, ...(value as object), verdicts: program!.verdicts } as Program;
}

/** An answer of the server, in the form of api.ts. */
export function convert(method: Method, result: unknown): unknown {
  if (method === 'picture') return pictureOf(result as Picture);
  if (method === 'trace' || method === 'part') return traceOf(result as { [key: string]: unknown });
  if (method === 'simulate') return simulationOf(result as Simulation);
  if (method === 'steps') return { ...(result as RunSteps), steps: (result as RunSteps).steps.map(stepOf) };
  if (method !== 'hello') return result;
  const hello = result as Hello & { program: unknown; show?: { given?: unknown } };
  if (hello.program) hello.program = programOf(hello.program);
  if (hello.show?.given) hello.show.given = traceOf(hello.show.given as { [key: string]: unknown } & Trace);
  if (hello.run) {
    hello.run.trace = traceOf(hello.run.trace as unknown as { [key: string]: unknown });
    for (const process of hello.run.processes) process.places = process.places.map(locationOf);
    for (const property of hello.run.properties) property.location = locationOf(property.location);
  }
  return hello;
}

function simulationOf(value: Simulation): Simulation {
  return { ...value, trace: traceOf(value.trace as unknown as { [key: string]: unknown }), choices: value.choices.map(stepOf) };
}
