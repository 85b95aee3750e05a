import { spawn, type ChildProcess } from 'node:child_process';
import { request } from 'node:http';
import { convert, programOf } from '../../../panel/src/host/convert';
import type { Server } from '../find_server';
import type { panel } from '../protocol';

/** Milliseconds that a run may take until its page can be reached: a platform may have to start. */
const kStart = 60_000;
/** Milliseconds between a request to end and the next, stronger one: actions have five seconds to stop. */
const kStop = 12_000;

interface RawNews {
  next: number;
  news: { method: string; params: unknown }[];
}

/** `proskill run --view` of a program: its page is served to us instead of a browser. */
export class RunProcess {
  private constructor(private readonly child: ChildProcess, private readonly address: string, private readonly complaints: () => string) {}

  /** Starts a run. The error is what the program says, such as an error of the platform file. */
  static start(server: Server, options: string[], cwd: string): Promise<RunProcess> {
    const child = spawn(server.command, ['run', '--view', '--no-open', '--format', 'json', ...options], { cwd, env: { ...process.env, ...server.env }, stdio: ['ignore', 'ignore', 'pipe'] });
    let said = '';
    return new Promise((resolve, reject) => {
      const late = setTimeout(() => {
        child.kill('SIGKILL');
        reject(new Error(`the run does not begin. ${said}`));
      }, kStart);
      child.stderr.setEncoding('utf8').on('data', (text: string) => {
        said = (said + text).slice(-8_000);
        const address = /shown at (http:\/\/\S+)/.exec(said)?.[1];
        if (!address) return;
        clearTimeout(late);
        resolve(new RunProcess(child, address, () => said));
      });
      child.on('error', reject);
      child.on('exit', () => {
        clearTimeout(late);
        reject(new Error(said.trim() || 'the run ended before it began'));
      });
    });
  }

  /** A request of the panel; the answer has the panel's form. */
  async call(method: panel.Method, params: unknown): Promise<unknown> {
    return convert(method, await this.post(method, params));
  }

  /** Passes on news until the process ends. */
  async listen(tell: (method: string, params: unknown) => void): Promise<void> {
    for (let next = 0; ;) {
      const answer = (await this.post('news', { after: next })) as RawNews;
      next = answer.next;
      for (const { method, params } of answer.news) tell(method, method === 'program' ? programOf(params) : params);
    }
  }

  onEnd(ended: (code: number | null, said: string) => void): void {
    if (this.child.exitCode !== null || this.child.signalCode !== null) ended(this.child.exitCode, this.complaints());
    else this.child.once('exit', (code) => ended(code, this.complaints()));
  }

  /** Ends the run: its actions are asked to stop, in order, and have their time for it. */
  end(): void {
    this.child.kill('SIGTERM');
    const stronger = setTimeout(() => this.child.kill('SIGKILL'), kStop);
    this.child.once('exit', () => clearTimeout(stronger));
  }

  private post(method: string, params: unknown): Promise<unknown> {
    const body = JSON.stringify(params ?? {});
    return new Promise((resolve, reject) => {
      const asked = request(new URL(`api/${method}`, this.address), {
        method: 'POST', headers: { 'Content-Type': 'application/json', 'Content-Length': Buffer.byteLength(body) },
      }, (response) => {
        const parts: Buffer[] = [];
        response.on('data', (part: Buffer) => parts.push(part)).on('error', reject).on('end', () => {
          try {
            const text = Buffer.concat(parts).toString('utf8');
            if (response.statusCode !== 200) throw new Error(`the run answers ${response.statusCode}: ${text.trim()}`);
            const answer = JSON.parse(text) as { result?: unknown; error?: string };
            if (answer.error !== undefined) throw new Error(answer.error);
            resolve(answer.result);
          } catch (error) {
            reject(error);
          }
        });
      });
      asked.on('error', reject).end(body);
    });
  }
}
