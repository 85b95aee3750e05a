import type { Hello, Host, Method, News, NewsOf, Picture, Program, Requests, RunSteps, Simulation, Trace } from '../api.ts';
import { locationOf, open, stepOf, traceOf } from '../model/parse.ts';
import { pictureOf } from './pictures.ts';

interface Answer {
  result?: unknown;
  error?: string;
}
interface RawNews {
  next: number;
  news: { method: keyof News; params: unknown }[];
}

/**
 * `proskill view`: `POST api/METHOD` below the address of the page, whose path has the token. The page requests events in a loop; the server answers
 * when there are some.
 */
export class HttpHost implements Host {
  private readonly listeners: ((...news: NewsOf) => void)[] = [];

  async request<M extends Method>(method: M, params: Requests[M][0]): Promise<Requests[M][1]> {
    const result = await this.post(`api/${method}`, params);
    if (method === 'hello') void this.listen();
    return convert(method, result) as Requests[M][1];
  }

  tell(): void {
    // The panel shows the source itself; nobody else listens.
  }

  onNews(listener: (...news: NewsOf) => void): void {
    this.listeners.push(listener);
  }

  private async post(path: string, params: unknown): Promise<unknown> {
    const response = await fetch(path, {
      method: 'POST', headers: { 'Content-Type': 'application/json' }, body: JSON.stringify(params),
    });
    if (!response.ok) throw new Error(`proskill view answers ${response.status} ${response.statusText}`);
    const answer = (await response.json()) as Answer;
    if (answer.error !== undefined) throw new Error(answer.error);
    return answer.result;
  }

  private async listen(): Promise<void> {
    for (let next = 0; ; ) {
      try {
        const answer = (await this.post('api/news', { after: next })) as RawNews;
        next = answer.next;
        for (const { method, params } of answer.news) this.announce(method, params);
      } catch {
        this.announce('gone', {});
        return;
      }
    }
  }

  private announce(method: keyof News, params: unknown): void {
    const news = method === 'program' ? programOf(params) : params;
    for (const listener of this.listeners) listener(...([method, news] as NewsOf));
  }
}

/** The server's programs are reports in the form of docs/verify.schema.json, with more members. */
export function programOf(value: unknown): Program {
  const { program } = open(JSON.stringify(value));
  return { ...program!, ...(value as object), verdicts: program!.verdicts } as Program;
}

function convert(method: Method, result: unknown): unknown {
  if (method === 'picture') return pictureOf(result as Picture);
  if (method === 'trace') return traceOf(result as { [key: string]: unknown });
  if (method === 'simulate') return simulationOf(result as Simulation);
  if (method === 'steps') return { ...(result as RunSteps), steps: (result as RunSteps).steps.map(stepOf) };
  if (method !== 'hello') return result;
  const hello = result as Hello & { program: unknown; show?: { given?: unknown } };
  if (hello.program) hello.program = programOf(hello.program);
  if (hello.show?.given) hello.show.given = traceOf(hello.show.given as { [key: string]: unknown } & Trace);
  if (hello.run) {
    hello.run.trace = traceOf(hello.run.trace as unknown as { [key: string]: unknown });
    for (const process of hello.run.processes) process.places = process.places.map(locationOf);
  }
  return hello;
}

function simulationOf(value: Simulation): Simulation {
  return { ...value, trace: traceOf(value.trace as unknown as { [key: string]: unknown }), choices: value.choices.map(stepOf) };
}
