// @ts-check
// The form of a decision: yes or no, boats, an option, or fields that are typed or drawn on the map.
import {element} from './dom.js';

/** @typedef {import('./link.js').Link} Link @typedef {import('./chart.js').Chart} Chart */

export class DecisionForm {
  /**
   * @param {any} decision its row
   * @param {Link} link
   * @param {Chart} chart
   * @param {{say: (text: string, isFault: boolean) => void, back: () => void, resized: () => void}} page
   */
  constructor(decision, link, chart, page) {
    this.decision = decision;
    this.link = link;
    this.chart = chart;
    this.page = page;
    /** @type {Map<string, any[]>} */
    this.drawn = new Map();
    /** @type {HTMLElement | null} */
    this.bar = null;
    this.answers = element('div', {class: 'answers'});
    this.faults = element('p', {class: 'fault', role: 'alert'});
    const back = element('button', {class: 'back', 'aria-label': 'Back to the list', onclick: () => page.back()}, '‹');
    this.node = element('section', {class: 'decision'}, element('header', {}, back, element('h2', {}, decision.title)), ...this.words(), this.form(), this.faults, this.answers);
    chart.preview([
      ...(decision.shapes ?? []),
      ...(decision.options ?? []).filter((/** @type {any} */ one) => one.shape && one.selected).map((/** @type {any} */ one) => ({label: '', shape: one.shape})),
      ...(decision.fields ?? []).filter((/** @type {any} */ one) => one.shape).map((/** @type {any} */ one) => ({label: '', shape: one.shape})),
    ]);
  }

  words() {
    const d = this.decision;
    const where = [d.plan, d.place].filter(Boolean).join(' · ');
    const lines = (d.description ?? []).map((/** @type {string} */ line) => element('p', {}, line));
    return [element('p', {class: 'where'}, where), ...lines];
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
        this.button('Confirm', () => ({fields: this.fieldValues()}), true);
        return element('div', {class: 'fields'}, ...d.fields.map((/** @type {any} */ field) => this.field(field)));
    }
  }

  /** @param {string} text @param {() => any} answer @param {boolean} [main] */
  button(text, answer, main = false) {
    this.answers.append(element('button', {class: main ? 'main' : '', onclick: () => this.give(answer)}, text));
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
      const box = /** @type {HTMLInputElement} */ (element('input', {type: 'checkbox', value: one.value, checked: one.selected}));
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
    const all = () => boxes.forEach((one) => (one.box.checked = true));
    return element('div', {}, element('button', {onclick: all}, 'All'), ...boxes.map((one) => one.node));
  }

  options() {
    const d = this.decision;
    const name = 'option-' + d.id;
    const radios = d.options.map((/** @type {any} */ one) => {
      const show = () => one.shape && this.chart.preview([...(d.shapes ?? []), {label: '', shape: one.shape}]);
      const radio = /** @type {HTMLInputElement} */ (element('input', {type: 'radio', name, value: one.index, checked: one.selected || d.options.length === 1, onchange: show}));
      return {radio, node: element('label', {class: 'row'}, radio, element('span', {}, one.label), element('small', {}, one.detail))};
    });
    const confirm = () => {
      const chosen = radios.find((one) => one.radio.checked);
      if (!chosen) {
        throw new Error('Choose one.');
      }
      return {option: Number(chosen.radio.value)};
    };
    this.button('Confirm', confirm, true);
    if (d.reject) {
      this.button('None of them', () => ({none: true}));
    }
    return element('div', {}, ...radios.map((one) => one.node));
  }

  // ---- fields

  /** @param {any} field */
  field(field) {
    const title = field.key + (field.unit ? ' (' + field.unit + ')' : '');
    const parts = /** @type {(Node|string)[]} */ ([element('span', {class: 'key'}, title), element('small', {}, field.help ?? '')]);
    if (!field.editable) {
      parts.push(element('output', {}, field.shape ? 'on the map' : DecisionForm.text(field.value)));
      return element('div', {class: 'field'}, ...parts);
    }
    parts.push(this.input(field));
    return element('label', {class: 'field'}, ...parts);
  }

  /** @param {any} value */
  static text(value) {
    return value === undefined ? '' : typeof value === 'object' ? JSON.stringify(value) : String(value);
  }

  /** @param {any} field */
  input(field) {
    const now = field.value;
    if (field.choices) {
      return this.named(field, element('select', {}, ...field.choices.map((/** @type {string} */ one) => element('option', {value: one, selected: one === now}, one))));
    }
    switch (field.type) {
      case 'boolean':
        return this.named(field, element('input', {type: 'checkbox', checked: now === true}));
      case 'integer':
      case 'real':
        return this.named(field, element('input', {type: 'number', step: field.type === 'integer' ? 1 : 'any', value: now, inputmode: 'decimal'}));
      case 'proxy':
        return this.named(field, element('select', {}, ...this.link.all('boats').map((boat) => element('option', {value: boat.id, selected: boat.id === now}, boat.id))));
      case 'point':
      case 'path':
      case 'area':
      case 'list<point>':
        return this.draw(field);
      default:
        return this.named(field, element('input', {type: 'text', value: DecisionForm.text(now)}));
    }
  }

  /** @param {any} field @param {HTMLElement} input */
  named(field, input) {
    input.dataset.key = field.key;
    return input;
  }

  /** Points are tapped on the map. @param {any} field */
  draw(field) {
    const many = field.type !== 'point';
    const count = element('output', {}, field.value === undefined ? 'nothing yet' : 'as shown');
    const points = /** @type {any[]} */ ([]);
    const bar = element('div', {class: 'bar'});
    const shown = () => {
      count.textContent = points.length === 1 ? '1 point' : points.length + ' points';
      bar.firstChild?.replaceWith(count.textContent);
      this.drawn.set(field.key, points);
      this.chart.draft(points.length === 0 ? null : DecisionForm.shape(field.type, points));
    };
    const take = (/** @type {[number, number]} */ point) => {
      if (!many) {
        points.length = 0;
      }
      points.push(point);
      shown();
    };
    const undo = () => {
      points.pop();
      shown();
    };
    const done = () => {
      this.stopDrawing();
      document.body.classList.add('open');
      this.page.resized();
    };
    bar.append(many ? 'Touch the points, one after another' : 'Touch the place',
      element('button', {type: 'button', onclick: undo}, 'Undo'), element('button', {type: 'button', class: 'main', onclick: done}, 'Done'));
    const begin = () => {
      this.stopDrawing();
      this.chart.taking = take;
      this.bar = bar;
      document.body.append(bar);
      document.body.classList.add('drawing');
      document.body.classList.remove('open');
      this.page.resized();
    };
    return element('span', {class: 'draw'}, element('button', {type: 'button', onclick: begin}, 'Draw on the map'), count);
  }

  /** @param {string} type @param {any[]} points */
  static shape(type, points) {
    if (type === 'area' && points.length > 2) {
      return {area: points};
    }
    return type === 'point' ? {point: points[0]} : type === 'list<point>' ? {many: points.map((point) => ({shape: {point}}))} : {path: points};
  }

  fieldValues() {
    const values = /** @type {Record<string, any>} */ ({});
    for (const field of this.decision.fields) {
      if (field.editable) {
        const value = this.value(field);
        if (value !== undefined) {
          values[field.key] = value;
        } else if (!field.optional) {
          throw new Error(field.key + ' is missing.');
        }
      }
    }
    return values;
  }

  /** @param {any} field */
  value(field) {
    const points = this.drawn.get(field.key)?.map(([lat, lon]) => ({lat, lon}));
    if (['point', 'path', 'area', 'list<point>'].includes(field.type)) {
      return points === undefined ? field.value : DecisionForm.drawnValue(field, points);
    }
    const input = /** @type {any} */ (this.node.querySelector('[data-key="' + CSS.escape(field.key) + '"]'));
    if (input.type === 'checkbox') {
      return input.checked;
    }
    if (input.value === '') {
      return undefined;
    }
    if (input.type === 'number') {
      return Number(input.value);
    }
    return typeof field.value === 'object' || field.type.startsWith('list<') ? DecisionForm.parsed(field, input.value) : input.value;
  }

  /** @param {any} field @param {string} text */
  static parsed(field, text) {
    try {
      return JSON.parse(text);
    } catch {
      throw new Error(field.key + ' is not JSON' + (field.value === undefined ? '' : ' such as ' + JSON.stringify(field.value)) + '.');
    }
  }

  /** @param {any} field @param {any[]} points */
  static drawnValue(field, points) {
    const least = field.type === 'area' ? 3 : field.type === 'path' ? 2 : 1;
    if (points.length < least) {
      throw new Error(field.key + ' needs ' + least + (least === 1 ? ' point' : ' points') + ' on the map.');
    }
    return field.type === 'point' ? points[0] : field.type === 'area' ? {outline: points, holes: []} : points;
  }

  stopDrawing() {
    this.chart.taking = null;
    this.bar?.remove();
    this.bar = null;
    document.body.classList.remove('drawing');
  }

  /** What it shows on the map goes away. */
  close() {
    this.stopDrawing();
    this.chart.preview([]);
    this.chart.draft(null);
  }
}
