import type { Hello, Host, Method, Picture, PictureParams, Requests, Trace } from '../api.ts';
import { open } from '../model/parse.ts';
import { programOf } from './convert.ts';
import { pictureOf } from './pictures.ts';

/** Data that `proskill verify --report` writes into its page. */
interface Report {
  report: { [key: string]: unknown };
  sources: { [uri: string]: string };
  pictures: { params: Omit<PictureParams, 'format'>; svg: Picture; dot?: string }[];
}

/** A single page, which contains all answers. */
export class ReportHost implements Host {
  private readonly traces: Map<string, Trace>;
  private readonly report: Report;

  constructor(text: string) {
    this.report = JSON.parse(text) as Report;
    this.traces = new Map(open(JSON.stringify(this.report.report)).traces.map((trace) => [trace.name, trace]));
  }

  async request<M extends Method>(method: M, params: Requests[M][0]): Promise<Requests[M][1]> {
    return this.answer(method, params) as Requests[M][1];
  }
  tell(): void {
    // Nobody listens.
  }
  onNews(): void {
    // A report never changes.
  }

  private answer(method: Method, params: unknown): unknown {
    switch (method) {
      case 'hello': return this.hello();
      case 'trace': return this.traces.get((params as { name: string }).name) ?? fail('this property has no trace');
      case 'source': return this.source((params as { uri: string }).uri);
      case 'picture': return this.picture(params as PictureParams);
      case 'save':
      case 'open':
      case 'simulate':
      case 'steps':
      case 'control':
      case 'verify': return fail('a report cannot do this');
    }
  }

  private hello(): Hello {
    return {
      contract: 1, layout: 'all', can: { source: true, save: false, open: false, verify: false, simulate: false, follow: false },
      program: programOf(this.report.report),
    };
  }

  private source(uri: string): { uri: string; text: string } {
    return { uri, text: this.report.sources[uri] ?? fail(`the report does not have the text of ${uri}`) };
  }

  /** Either all branches are folded, or none. */
  private picture(params: PictureParams): Picture {
    const fold = (params.fold?.length ?? 0) > 0;
    const all = this.report.pictures.filter(
      (it) => it.params.kind === params.kind && it.params.name === params.name && (it.params.dark ?? false) === params.dark);
    const plain = all.filter((it) => (it.params.forbidden ?? false) === (params.forbidden ?? false));
    const chosen = (plain.length > 0 ? plain : all).find((it) => ((it.params.fold?.length ?? 0) > 0) === fold) ?? plain[0] ?? all[0];
    if (!chosen) return fail('the report does not have this picture');
    const picture = pictureOf(chosen.svg);
    return params.format === 'dot' ? { ...picture, content: chosen.dot ?? fail('the report has no DOT of this picture') } : picture;
  }
}

function fail(words: string): never {
  throw new Error(words);
}
