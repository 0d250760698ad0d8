// What boats measure: the newest value of each channel, and the layer of readings that is chosen for the map or that a decision asks for.
import {byId, duration, element} from './dom.js';
import {Field} from './field.js';
import type {Chart} from './chart.js';
import type {Link} from './link.js';
import type {Information, Layer} from './protocol.js';

const AGAIN_MS = 5000;
const OLD_MS = 60000;

/** A word of a vocabulary as people read it. */
export function plain(word: string) {
  if (word.length < 4) {
    return word; // pH
  }
  const text = word.replaceAll('_', ' ').toLowerCase();
  return text.charAt(0).toUpperCase() + text.slice(1);
}

/** A value with its unit. */
export function figure(value: number, unit?: string) {
  const digits = Math.abs(value) >= 1000 ? 0 : Math.abs(value) >= 100 ? 1 : 2;
  return value.toFixed(digits) + (unit ? ' ' + unit : '');
}

/** The newest readings of a boat. */
export function readingsOf(link: Link, boat: string): HTMLElement | null {
  const rows = link.row('readings', boat)?.readings ?? [];
  if (rows.length === 0) {
    return null;
  }
  return element('dl', {class: 'readings', 'aria-label': 'Readings of ' + boat}, ...rows.flatMap((one) => {
    const age = link.now() - one.at;
    return [
      element('dt', {}, plain(one.channel), element('small', {}, one.sensor)),
      element('dd', {class: age > OLD_MS ? 'old' : ''}, element('b', {}, figure(one.value, one.unit)), element('small', {}, duration(age) + ' ago'))];
  }));
}

export class Readings {
  link: Link;
  field: Field;
  chosen: Information | null;
  wanted: string;
  askedAt: number;
  listed: string;

  constructor(link: Link, chart: Chart) {
    this.link = link;
    this.field = new Field(chart.map);
    this.chosen = null;
    this.wanted = '';
    this.askedAt = 0;
    this.listed = '';
    byId('layer').addEventListener('change', () => {
      const sensor = byId('layer').value;
      this.chosen = sensor === '' ? null : {sensor, visualization: 'heatmap'};
    });
  }

  /** Follows what is measured and asked for; called often. @param asked by the decision that is open */
  show(asked: Information | null) {
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

  /** The channels that boats measure, by the name of each in the link. */
  channels(): Map<string, string> {
    const found = new Map<string, string>();
    for (const row of this.link.all('readings')) {
      row.readings.forEach((one) => found.set(one.sensor + '/' + one.channel, plain(one.channel) + ' (' + one.sensor + ')'));
    }
    return new Map([...found].sort((one, other) => one[1].localeCompare(other[1])));
  }

  list(channels: Map<string, string>) {
    const text = [...channels.keys()].join('\n');
    if (text !== this.listed) {
      this.listed = text;
      byId('layer').replaceChildren(element('option', {value: ''}, 'Readings: none'), ...[...channels].map(([value, words]) => element('option', {value, selected: value === this.chosen?.sensor}, words)));
    }
  }

  async ask(want: Information, wanted: string) {
    if (!this.link.isOpen || document.hidden) {
      return;
    }
    const reply = await this.link.ask({t: 'layer', ...want});
    if (wanted === this.wanted) {
      this.draw((reply.t === 'done' && reply.layer) || null);
    }
  }

  draw(layer: Layer | null) {
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
