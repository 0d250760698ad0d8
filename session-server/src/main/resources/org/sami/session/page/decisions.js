// @ts-check
// The form of a decision: yes or no, boats, an option, or fields. It keeps what is half filled in while other lists are looked at.
import {Drawing} from './drawing.js';
import {duration, element} from './dom.js';
import {Fields} from './fields.js';

/** @typedef {import('./link.js').Link} Link @typedef {import('./chart.js').Chart} Chart */

const JUDGE_MS = 400; // after the last change

export class DecisionForm {
  /**
   * @param {any} decision its row
   * @param {Link} link
   * @param {Chart} chart
   * @param {import('./pictures.js').Pictures} pictures
   * @param {{say: (text: string, isFault: boolean) => void, back: () => void, resized: () => void}} page
   */
  constructor(decision, link, chart, pictures, page) {
    this.decision = decision;
    this.link = link;
    this.chart = chart;
    this.pictures = pictures;
    this.page = page;
    this.drawing = new Drawing(chart, page.resized);
    /** @type {Fields | null} */
    this.fields = null;
    /** @type {(() => any) | null} */
    this.main = null;
    /** @type {any[]} */
    this.chosen = (decision.options ?? []).filter((/** @type {any} */ one) => one.selected);
    this.judging = 0;
    this.answers = element('div', {class: 'answers'});
    this.faults = element('p', {class: 'fault', role: 'alert'});
    this.warnings = element('p', {class: 'warning', role: 'status'});
    this.timer = element('div', {class: 'timer'});
    this.state = element('div', {class: 'boat-states'});
    this.seen = element('div', {class: 'seen-by'});
    const back = element('button', {class: 'back', 'aria-label': 'Back to the list', onclick: () => page.back()}, '‹');
    const where = [decision.plan, decision.place].filter(Boolean).join(' · ');
    const lines = (decision.description ?? []).map((/** @type {string} */ line) => element('p', {}, line));
    this.node = element('section', {class: 'decision'}, element('header', {}, back, element('h2', {}, decision.title)),
      element('p', {class: 'where'}, where), ...lines, this.timer, this.state, this.seen, this.form(), this.warnings, this.faults, this.answers);
    this.tick();
  }

  /** The row has changed, or time has passed. @param {any} [decision] */
  tick(decision) {
    this.decision = decision ?? this.decision;
    const d = this.decision;
    const left = d.deadline === undefined ? '' : 'In ' + duration(d.deadline - this.link.now()) + ' it ' + d.autonomy + '.';
    if (this.timer.dataset.words !== left) {
      this.timer.dataset.words = left;
      const stop = d.yours ? element('button', {type: 'button', onclick: () => this.hold()}, 'Stop the timer') : null;
      this.timer.replaceChildren(...(left === '' ? [] : [element('span', {}, left), ...(stop ? [stop] : [])]));
    }
    const state = d.show?.state ? this.link.all('boats').filter((boat) => d.show.boats.includes(boat.id)).map(DecisionForm.stateOf) : [];
    if (this.state.dataset.words !== state.join('\n')) {
      this.state.dataset.words = state.join('\n');
      this.state.replaceChildren(...state.map((line) => element('p', {}, line)));
    }
    this.showPictures();
  }

  /** The layer of readings that it asks for. @returns {{sensor: string, visualization: string} | null} */
  layer() {
    const d = this.decision;
    return d.information ?? (d.show?.data ? {sensor: '', visualization: 'heatmap'} : null);
  }

  /** The pictures that boats had taken last when the question came, where it shows them. */
  showPictures() {
    const d = this.decision;
    const taken = d.show?.pictures ? d.show.boats.flatMap((/** @type {string} */ boat) => this.pictures.lastOf(boat, d.opened)) : [];
    const strip = this.pictures.strip(taken);
    if (this.seen.dataset.html !== (strip?.outerHTML ?? '')) {
      this.seen.dataset.html = strip?.outerHTML ?? '';
      this.seen.replaceChildren(...(strip ? [strip] : []));
    }
  }

  /** @param {any} boat */
  static stateOf(boat) {
    return [boat.id, boat.battery === undefined ? null : Math.round(boat.battery) + ' %', boat.speed === undefined ? null : boat.speed.toFixed(1) + ' m/s', boat.link, boat.why].filter(Boolean).join(' · ');
  }

  /** Shows on the map what it is about. */
  show() {
    const d = this.decision;
    this.chart.preview([
      ...(d.shapes ?? []),
      ...this.chosen.filter((one) => one.shape).map((one) => ({label: '', shape: one.shape})),
      ...(d.fields ?? []).filter((/** @type {any} */ one) => one.shape).map((/** @type {any} */ one) => ({label: '', shape: one.shape})),
    ], d.view?.change === 'reduce');
    this.chart.stress(this.link, d);
    this.fields?.show();
  }

  async hold() {
    const reply = await this.link.ask({t: 'hold', decision: this.decision.id});
    this.page.say(reply.text || 'The timer is stopped', reply.t === 'refused');
  }

  form() {
    const d = this.decision;
    if (!d.yours) {
      return element('p', {class: 'hint'}, (d.whyNot ?? 'This question is not yours') + '.');
    }
    switch (d.form) {
      case 'yesNo':
        this.button('Yes', () => ({yes: true}), true);
        this.button('No', () => ({yes: false}));
        return element('div');
      case 'boats':
        return this.boats();
      case 'option':
        return this.options();
      default:
        this.fields = new Fields(d.fields, this.link, this.chart, this.drawing, () => this.changed());
        this.button('Confirm', () => ({fields: this.fields?.values()}), true);
        return this.fields.node;
    }
  }

  /** @param {string} text @param {() => any} answer @param {boolean} [main] */
  button(text, answer, main = false) {
    if (main && this.decision.form !== 'yesNo') {
      this.main = answer;
    }
    this.answers.append(element('button', {class: main ? 'main' : '', onclick: () => this.give(answer)}, text));
  }

  /** Asks, a little after the last change, what the session thinks of the answer as it is. */
  changed() {
    this.faults.textContent = '';
    clearTimeout(this.judging);
    this.judging = window.setTimeout(async () => {
      let answer;
      try {
        answer = this.main?.();
      } catch {
        return; // not whole yet
      }
      const reply = await this.link.ask({t: 'judge', decision: this.decision.id, answer});
      this.warnings.textContent = reply.t === 'refused' ? reply.text : (reply.warnings ?? []).join(' ');
    }, JUDGE_MS);
  }

  /** @param {() => any} answer */
  async give(answer) {
    let given;
    try {
      given = answer();
    } catch (fault) {
      this.faults.textContent = /** @type {Error} */ (fault).message;
      return;
    }
    const reply = await this.link.ask({t: 'answer', decision: this.decision.id, answer: given});
    if (reply.t === 'done') {
      this.page.say(reply.text || 'Answered', false);
      this.page.back();
    } else {
      this.faults.textContent = reply.text;
    }
  }

  boats() {
    const d = this.decision;
    const boxes = d.options.map((/** @type {any} */ one) => {
      const box = /** @type {HTMLInputElement} */ (element('input', {type: 'checkbox', value: one.value, checked: one.selected, onchange: () => this.changed()}));
      return {box, node: element('label', {class: 'row'}, box, element('span', {}, one.label), element('small', {}, one.detail))};
    });
    const chosen = () => boxes.filter((one) => one.box.checked).map((one) => one.box.value);
    const confirm = () => {
      const count = chosen().length;
      if (count < d.min || count > d.max) {
        throw new Error(d.min === d.max ? 'Choose ' + d.min + '.' : 'Choose ' + d.min + ' to ' + d.max + '.');
      }
      return {boats: chosen()};
    };
    this.button('Confirm', confirm, true);
    if (d.reject) {
      this.button('None of them', () => ({none: true}));
    }
    const all = () => {
      boxes.forEach((one) => (one.box.checked = true));
      this.changed();
    };
    return element('div', {}, element('button', {onclick: all}, 'All'), ...boxes.map((one) => one.node));
  }

  options() {
    const d = this.decision;
    if (this.chosen.length === 0 && (d.options.length === 1 || d.format !== 'stacked')) {
      this.chosen = d.options.slice(0, 1);
    }
    this.button('Confirm', () => {
      if (this.chosen.length !== 1) {
        throw new Error('Choose one.');
      }
      return {option: this.chosen[0].index};
    }, true);
    if (d.reject) {
      this.button('None of them', () => ({none: true}));
    }
    return d.format === 'stacked' || d.options.length === 1 ? this.stacked() : this.oneAtATime();
  }

  /** @param {any} option */
  choose(option) {
    this.chosen = [option];
    this.show();
    this.changed();
  }

  stacked() {
    const name = 'option-' + this.decision.id;
    return element('div', {}, ...this.decision.options.map((/** @type {any} */ one) =>
      element('label', {class: 'row'}, element('input', {type: 'radio', name, checked: this.chosen.includes(one), onchange: () => this.choose(one)}),
        element('span', {}, one.label), element('small', {}, one.detail))));
  }

  /** By tabs, or by steps from one to the next. */
  oneAtATime() {
    const options = this.decision.options;
    const body = element('div', {class: 'row'});
    const head = element('div', {class: 'steps', role: this.decision.format === 'tabs' ? 'tablist' : 'group'});
    const show = (/** @type {number} */ at) => {
      const one = options[at];
      body.replaceChildren(element('strong', {}, one.label), element('small', {}, one.detail));
      head.replaceChildren(...(this.decision.format === 'tabs'
        ? options.map((/** @type {any} */ tab, /** @type {number} */ index) => element('button', {type: 'button', role: 'tab', 'aria-selected': String(index === at), onclick: () => go(index)}, String(index + 1)))
        : [element('button', {type: 'button', disabled: at === 0, 'aria-label': 'The one before', onclick: () => go(at - 1)}, '‹'),
          element('span', {}, at + 1 + ' of ' + options.length),
          element('button', {type: 'button', disabled: at === options.length - 1, 'aria-label': 'The next', onclick: () => go(at + 1)}, '›')]));
    };
    const go = (/** @type {number} */ at) => {
      show(at);
      this.choose(options[at]);
    };
    show(Math.max(0, options.indexOf(this.chosen[0])));
    return element('div', {}, head, body);
  }

  /** What it shows on the map goes away; what was filled in stays. */
  close() {
    this.drawing.end();
    this.chart.preview([]);
    this.chart.stress(this.link, null);
    this.chart.draft(null);
  }
}
