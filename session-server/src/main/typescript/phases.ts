// How far a mission is: the phases of its plan below each other, each with who does what. The phase that is under way is open.
import {element} from './dom.js';
import type {Action, Phase, PhasesRow, PhaseState} from './protocol.js';

const MARKS: Record<PhaseState, string> = {active: '▶', begun: '◐', done: '✓', ahead: '○'};
const WORDS: Record<PhaseState, string> = {active: 'under way', begun: 'begun', done: 'done', ahead: 'not begun'};

/** What a person opened or closed by hand, by mission and phase. */
const opened: Map<string, boolean> = new Map();

/** @param row of the table `phases`; undefined where the plan names none */
export function phases(row: PhasesRow | undefined, refresh: () => void): HTMLElement | null {
  return row ? element('ol', {class: 'phases', 'aria-label': 'Phases'}, ...row.phases.map((one) => phase(row.id, one, refresh))) : null;
}

function phase(mission: string, one: Phase, refresh: () => void) {
  const key = mission + ' ' + one.name;
  const isOpen = opened.get(key) ?? one.state === 'active';
  const done = one.actions.filter((action) => action.state === 'done').length;
  const toggle = () => {
    opened.set(key, !isOpen);
    refresh();
  };
  const head = element('button', {class: 'phase', 'aria-expanded': String(isOpen), onclick: toggle},
    mark(one.state), element('span', {class: 'name'}, one.name), element('span', {class: 'figures'}, done + ' of ' + one.actions.length));
  return element('li', {class: one.state}, head, isOpen ? element('ul', {}, ...one.actions.map(action)) : null);
}

function action(one: Action) {
  return element('li', {class: one.state}, mark(one.state), element('span', {class: 'name'}, one.label + (one.times ? ' (' + one.times + ' times)' : '')),
    element('span', {class: 'actor'}, actor(one.actor)));
}

/** The state as a sign, and as a word for who hears the page. */
function mark(state: PhaseState) {
  return element('span', {class: 'sign', role: 'img', 'aria-label': WORDS[state], title: WORDS[state]}, MARKS[state]);
}

/** An actor as people read it: the constants of a vocabulary are in capitals. */
function actor(word: string) {
  return /^[A-Z_]+$/.test(word) && word.length > 4 ? word.charAt(0) + word.slice(1).toLowerCase().replaceAll('_', ' ') : word;
}
