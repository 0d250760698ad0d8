// The form of a decision: yes or no, boats, an option, or fields. It keeps what is half filled in while other lists are looked at.
import {Drawing} from './drawing.js';
import {duration, element} from './dom.js';
import {Fields} from './fields.js';
import type {Chart} from './chart.js';
import type {Link} from './link.js';
import type {Pictures} from './pictures.js';
import type {Answer, BoatRow, BoatsDecision, DecisionRow, Information, Option, OptionDecision} from './protocol.js';

const JUDGE_MS = 400; // after the last change

/** What the form needs of the page around it. */
export interface Page {
  say(text: string, isFault: boolean): void;
  /** Leaves a form, where it is the one that is shown. */
  back(from: DecisionForm): void;
  resized(): void;
}

export class DecisionForm {
  decision: DecisionRow;
  link: Link;
  chart: Chart;
  pictures: Pictures;
  page: Page;
  drawing: Drawing;
  fields: Fields | null;
  main: (() => Answer) | null;
  chosen: Option[];
  judging: number;
  answers: HTMLElement;
  faults: HTMLElement;
  warnings: HTMLElement;
  timer: HTMLElement;
  state: HTMLElement;
  seen: HTMLElement;
  node: HTMLElement;

  /** @param decision its row */
  constructor(decision: DecisionRow, link: Link, chart: Chart, pictures: Pictures, page: Page) {
    this.decision = decision;
    this.link = link;
    this.chart = chart;
    this.pictures = pictures;
    this.page = page;
    this.drawing = new Drawing(chart, page.resized);
    this.fields = null;
    this.main = null;
    this.chosen = (decision.form === 'boats' || decision.form === 'option' ? decision.options : []).filter((one) => one.selected);
    this.judging = 0;
    this.answers = element('div', {class: 'answers'});
    this.faults = element('p', {class: 'fault', role: 'alert'});
    this.warnings = element('p', {class: 'warning', role: 'status'});
    this.timer = element('div', {class: 'timer'});
    this.state = element('div', {class: 'boat-states'});
    this.seen = element('div', {class: 'seen-by'});
    const back = element('button', {class: 'back', 'aria-label': 'Back to the list', onclick: () => page.back(this)}, '‹');
    const where = [decision.plan, decision.place].filter(Boolean).join(' · ');
    const lines = (decision.description ?? []).map((line) => element('p', {}, line));
    this.node = element('section', {class: 'decision'}, element('header', {}, back, element('h2', {}, decision.title)),
      element('p', {class: 'where'}, where), ...lines, this.timer, this.state, this.seen, this.form(), this.warnings, this.faults, this.answers);
    this.tick();
  }

  /** Whether a row asks the same question of the same person. Ids begin at 1 in each session, and `opened` is another where a base goes on with one. */
  asks(row: DecisionRow) {
    return DecisionForm.question(row) === DecisionForm.question(this.decision);
  }

  /** What a form is made of. */
  static question(row: DecisionRow) {
    const answers = row.form === 'fields' ? row.fields : row.form === 'yesNo' ? [] : row.options;
    const counts = row.form === 'boats' ? [row.min, row.max] : [];
    return JSON.stringify([row.mission, row.plan, row.place, row.type, row.form, row.format, row.title, row.description, row.reject, row.yours, row.whyNot, answers, counts]);
  }

  /** The row has changed, or time has passed. */
  tick(decision?: DecisionRow) {
    this.decision = decision ?? this.decision;
    const d = this.decision;
    const left = d.deadline === undefined ? '' : 'In ' + duration(d.deadline - this.link.now()) + ' it ' + d.autonomy + '.';
    if (this.timer.dataset.words !== left) {
      this.timer.dataset.words = left;
      const stop = d.yours ? element('button', {type: 'button', onclick: () => this.hold()}, 'Stop the timer') : null;
      this.timer.replaceChildren(...(left === '' ? [] : [element('span', {}, left), ...(stop ? [stop] : [])]));
    }
    const state = d.show?.state ? this.link.all('boats').filter((boat) => d.show?.boats.includes(boat.id)).map(DecisionForm.stateOf) : [];
    if (this.state.dataset.words !== state.join('\n')) {
      this.state.dataset.words = state.join('\n');
      this.state.replaceChildren(...state.map((line) => element('p', {}, line)));
    }
    this.showPictures();
  }

  /** The layer of readings that it asks for. */
  layer(): Information | null {
    const d = this.decision;
    return d.information ?? (d.show?.data ? {sensor: '', visualization: 'heatmap'} : null);
  }

  /** The pictures that boats had taken last when the question came, where it shows them. */
  showPictures() {
    const d = this.decision;
    const taken = d.show?.pictures ? d.show.boats.flatMap((boat) => this.pictures.lastOf(boat, d.opened)) : [];
    const strip = this.pictures.strip(taken);
    if (this.seen.dataset.html !== (strip?.outerHTML ?? '')) {
      this.seen.dataset.html = strip?.outerHTML ?? '';
      this.seen.replaceChildren(...(strip ? [strip] : []));
    }
  }

  static stateOf(boat: BoatRow) {
    return [boat.id, boat.battery === undefined ? null : Math.round(boat.battery) + ' %', boat.speed === undefined ? null : boat.speed.toFixed(1) + ' m/s', boat.link, boat.why].filter(Boolean).join(' · ');
  }

  /** Shows on the map what it is about. */
  show() {
    const d = this.decision;
    this.chart.preview([
      ...(d.shapes ?? []),
      ...this.chosen.flatMap((one) => (one.shape ? [{label: '', shape: one.shape}] : [])),
      ...(d.form === 'fields' ? d.fields : []).flatMap((one) => (one.shape ? [{label: '', shape: one.shape}] : [])),
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
        return this.boats(d);
      case 'option':
        return this.options(d);
      default:
        return this.given(new Fields(d.fields, this.link, this.chart, this.drawing, () => this.changed()));
    }
  }

  given(fields: Fields) {
    this.fields = fields;
    this.button('Confirm', () => ({fields: fields.values()}), true);
    return fields.node;
  }

  button(text: string, answer: () => Answer, main = false) {
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
      if (answer === undefined) {
        return; // there is no answer but those of its own buttons
      }
      const reply = await this.link.ask({t: 'judge', decision: this.decision.id, answer});
      this.warnings.textContent = reply.t === 'refused' ? reply.text : (reply.warnings ?? []).join(' ');
    }, JUDGE_MS);
  }

  async give(answer: () => Answer) {
    let given;
    try {
      given = answer();
    } catch (fault) {
      this.faults.textContent = (fault as Error).message;
      return;
    }
    const reply = await this.link.ask({t: 'answer', decision: this.decision.id, answer: given});
    if (reply.t === 'done') {
      this.page.say(reply.text || 'Answered', false);
      this.page.back(this);
    } else {
      this.faults.textContent = reply.text;
    }
  }

  boats(d: BoatsDecision) {
    const boxes = d.options.map((one) => {
      const box = element('input', {type: 'checkbox', value: one.value, checked: one.selected, onchange: () => this.changed()});
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

  options(d: OptionDecision) {
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
    return d.format === 'stacked' || d.options.length === 1 ? this.stacked(d) : this.oneAtATime(d);
  }

  choose(option: Option) {
    this.chosen = [option];
    this.show();
    this.changed();
  }

  stacked(d: OptionDecision) {
    const name = 'option-' + this.decision.id;
    return element('div', {}, ...d.options.map((one) =>
      element('label', {class: 'row'}, element('input', {type: 'radio', name, checked: this.chosen.includes(one), onchange: () => this.choose(one)}),
        element('span', {}, one.label), element('small', {}, one.detail))));
  }

  /** By tabs, or by steps from one to the next. */
  oneAtATime(d: OptionDecision) {
    const options = d.options;
    const body = element('div', {class: 'row'});
    const head = element('div', {class: 'steps', role: this.decision.format === 'tabs' ? 'tablist' : 'group'});
    const show = (at: number) => {
      const one = options[at];
      body.replaceChildren(element('strong', {}, one.label), element('small', {}, one.detail));
      head.replaceChildren(...(this.decision.format === 'tabs'
        ? options.map((_, index) => element('button', {type: 'button', role: 'tab', 'aria-selected': String(index === at), onclick: () => go(index)}, String(index + 1)))
        : [element('button', {type: 'button', disabled: at === 0, 'aria-label': 'The one before', onclick: () => go(at - 1)}, '‹'),
          element('span', {}, at + 1 + ' of ' + options.length),
          element('button', {type: 'button', disabled: at === options.length - 1, 'aria-label': 'The next', onclick: () => go(at + 1)}, '›')]));
    };
    const go = (at: number) => {
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
