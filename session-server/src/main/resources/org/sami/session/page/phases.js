// @ts-check
// How far a mission is: the phases of its plan below each other, each with who does what. The phase that is under way is open.
import {element} from './dom.js';

const MARKS = /** @type {Record<string, string>} */ ({active: '▶', begun: '◐', done: '✓', ahead: '○'});
const WORDS = /** @type {Record<string, string>} */ ({active: 'under way', begun: 'begun', done: 'done', ahead: 'not begun'});

/** What a person opened or closed by hand, by mission and phase. @type {Map<string, boolean>} */
const opened = new Map();

/**
 * @param {any} row of the table `phases`; undefined where the plan names none
 * @param {() => void} refresh
 * @returns {HTMLElement | null}
 */
export function phases(row, refresh) {
  return row ? element('ol', {class: 'phases', 'aria-label': 'Phases'}, ...row.phases.map((/** @type {any} */ one) => phase(row.id, one, refresh))) : null;
}

/** @param {string} mission @param {any} one @param {() => void} refresh */
function phase(mission, one, refresh) {
  const key = mission + ' ' + one.name;
  const isOpen = opened.get(key) ?? one.state === 'active';
  const done = one.actions.filter((/** @type {any} */ action) => action.state === 'done').length;
  const toggle = () => {
    opened.set(key, !isOpen);
    refresh();
  };
  const head = element('button', {class: 'phase', 'aria-expanded': String(isOpen), onclick: toggle},
    mark(one.state), element('span', {class: 'name'}, one.name), element('span', {class: 'figures'}, done + ' of ' + one.actions.length));
  return element('li', {class: one.state}, head, isOpen ? element('ul', {}, ...one.actions.map(action)) : null);
}

/** @param {any} one */
function action(one) {
  return element('li', {class: one.state}, mark(one.state), element('span', {class: 'name'}, one.label + (one.times ? ' (' + one.times + ' times)' : '')),
    element('span', {class: 'actor'}, actor(one.actor)));
}

/** The state as a sign, and as a word for who hears the page. @param {string} state */
function mark(state) {
  return element('span', {class: 'sign', role: 'img', 'aria-label': WORDS[state], title: WORDS[state]}, MARKS[state]);
}

/** An actor as people read it: the constants of a vocabulary are in capitals. @param {string} word */
function actor(word) {
  return /^[A-Z_]+$/.test(word) && word.length > 4 ? word.charAt(0) + word.slice(1).toLowerCase().replaceAll('_', ' ') : word;
}
