// @ts-check
// What boats measure: the newest value of each channel, and the layer of readings that is chosen for the map or that a decision asks for.
import {byId, duration, element} from './dom.js';
import {Field} from './field.js';

/** @typedef {import('./link.js').Link} Link */
/** @typedef {{sensor: string, visualization: string}} Asked */

const AGAIN_MS = 5000;
const OLD_MS = 60000;

/** A word of a vocabulary as people read it. @param {string} word */
export function plain(word) {
  if (word.length < 4) {
    return word; // pH
  }
  const text = word.replaceAll('_', ' ').toLowerCase();
  return text.charAt(0).toUpperCase() + text.slice(1);
}

/** A value with its unit. @param {number} value @param {string} [unit] */
export function figure(value, unit) {
  const digits = Math.abs(value) >= 1000 ? 0 : Math.abs(value) >= 100 ? 1 : 2;
  return value.toFixed(digits) + (unit ? ' ' + unit : '');
}

/** The newest readings of a boat. @param {Link} link @param {string} boat @returns {HTMLElement | null} */
export function readingsOf(link, boat) {
  const rows = link.row('readings', boat)?.readings ?? [];
  if (rows.length === 0) {
    return null;
  }
  return element('dl', {class: 'readings', 'aria-label': 'Readings of ' + boat}, ...rows.flatMap((/** @type {any} */ one) => {
    const age = link.now() - one.at;
    return [
      element('dt', {}, plain(one.channel), element('small', {}, one.sensor)),
      element('dd', {class: age > OLD_MS ? 'old' : ''}, element('b', {}, figure(one.value, one.unit)), element('small', {}, duration(age) + ' ago'))];
  }));
}

export class Readings {
  /** @param {Link} link @param {import('./chart.js').Chart} chart */
  constructor(link, chart) {
    this.link = link;
    this.field = new Field(chart.map);
    /** @type {Asked | null} */
    this.chosen = null;
    /** @type {string} */
    this.wanted = '';
    this.askedAt = 0;
    this.listed = '';
    byId('layer').addEventListener('change', () => {
      const sensor = byId('layer').value;
      this.chosen = sensor === '' ? null : {sensor, visualization: 'heatmap'};
    });
  }

  /** Follows what is measured and asked for; called often. @param {Asked | null} asked by the decision that is open */
  show(asked) {
    const channels = this.channels();
    byId('readings').hidden = channels.size === 0;
    this.list(channels);
    const want = channels.size === 0 ? null : asked ?? this.chosen;
    const wanted = want === null ? '' : JSON.stringify(want);
    const isOther = wanted !== this.wanted;
    this.wanted = wanted;
    if (want === null) {
      if (isOther) {
        this.draw(null);
      }
    } else if (isOther || Date.now() - this.askedAt > AGAIN_MS) {
      this.askedAt = Date.now();
      this.ask(want, wanted);
    }
  }

  /** The channels that boats measure, by the name of each in the link. @returns {Map<string, string>} */
  channels() {
    const found = new Map();
    for (const row of this.link.all('readings')) {
      row.readings.forEach((/** @type {any} */ one) => found.set(one.sensor + '/' + one.channel, plain(one.channel) + ' (' + one.sensor + ')'));
    }
    return new Map([...found].sort((one, other) => one[1].localeCompare(other[1])));
  }

  /** @param {Map<string, string>} channels */
  list(channels) {
    const text = [...channels.keys()].join('\n');
    if (text !== this.listed) {
      this.listed = text;
      byId('layer').replaceChildren(element('option', {value: ''}, 'Readings: none'), ...[...channels].map(([value, words]) => element('option', {value, selected: value === this.chosen?.sensor}, words)));
    }
  }

  /** @param {Asked} want @param {string} wanted */
  async ask(want, wanted) {
    if (!this.link.isOpen || document.hidden) {
      return;
    }
    const reply = await this.link.ask({t: 'layer', ...want});
    if (wanted === this.wanted) {
      this.draw(reply.layer ?? null);
    }
  }

  /** @param {any | null} layer */
  draw(layer) {
    this.field.show(layer);
    const legend = byId('legend');
    legend.hidden = layer === null;
    if (layer) {
      legend.className = byId('layer').value === layer.sensor + '/' + layer.channel ? '' : 'asked';
      legend.replaceChildren(element('span', {class: 'title'}, plain(layer.channel)),
        element('span', {}, figure(layer.least)), element('span', {class: 'scale'}), element('span', {}, figure(layer.greatest, layer.unit)));
    }
  }
}
