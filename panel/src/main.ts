import './style/base.css';
import './style/app.css';
import './style/trace.css';
import './style/automaton.css';
import './style/simulation.css';
import './style/run.css';
import './style/print.css';
import { chooseHost } from './host/choose.ts';
import { start } from './view/app.ts';

void start(document.getElementById('panel') ?? document.body, chooseHost());
