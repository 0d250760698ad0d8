// Points of what is drawn, each as large as a finger: dragged to move, touched to choose; between two that are far apart one that adds a point.
import * as L from './leaflet/leaflet-src.esm.js';
import type {LatLon} from './protocol.js';

const SIZE = 48;
const ROOM = 110; // pixels between two points, for one between them
export const MOST = 200;

/** Who hears what a hand does with the points. */
export interface Heard {
  begun(): void;
  moved(): void;
  over(): void;
  chosen(at: number): void;
}

export class Handles {
  map: L.Map;
  layer: L.LayerGroup;
  points: LatLon[];
  type: string;
  heard: Heard | null;
  selected: number | null;

  /** @param map of Leaflet */
  constructor(map: L.Map) {
    this.map = map;
    this.layer = L.layerGroup().addTo(map);
    this.points = [];
    this.type = '';
    this.heard = null;
    this.selected = null;
    map.on('zoomend', () => this.draw());
  }

  /** Shows points, which are changed in place. */
  show(type: string, points: LatLon[], selected: number | null, heard: Heard) {
    this.type = type;
    this.points = points;
    this.selected = selected;
    this.heard = heard;
    this.draw();
  }

  clear() {
    this.heard = null;
    this.layer.clearLayers();
  }

  draw() {
    this.layer.clearLayers();
    if (!this.heard || this.points.length > MOST) {
      return;
    }
    this.between().forEach((at) => this.add(Handles.middle(this.points[at], this.points[(at + 1) % this.points.length]), 'between', at + 1, true));
    this.points.forEach((point, at) => this.add(point, at === this.selected ? 'selected' : '', at, false));
  }

  /** Indexes of points behind which there is room for one more. */
  between() {
    const lines = this.type === 'path' ? this.points.length - 1 : this.type === 'area' && this.points.length > 2 ? this.points.length : 0;
    return [...Array(Math.max(0, lines)).keys()].filter((at) => {
      const one = this.map.latLngToContainerPoint(this.points[at]);
      return one.distanceTo(this.map.latLngToContainerPoint(this.points[(at + 1) % this.points.length])) > ROOM;
    });
  }

  static middle(one: LatLon, other: LatLon): LatLon {
    return [(one[0] + other[0]) / 2, (one[1] + other[1]) / 2];
  }

  add(point: LatLon, mark: string, at: number, isNew: boolean) {
    const marker = L.marker(point, {draggable: true, autoPan: true, keyboard: false, icon: L.divIcon({className: 'handle ' + mark, iconSize: [SIZE, SIZE]}), zIndexOffset: isNew ? 900 : 1000});
    marker.on('dragstart', () => {
      this.heard?.begun();
      if (isNew) {
        this.points.splice(at, 0, point);
      }
    });
    marker.on('drag', () => {
      const {lat, lng} = marker.getLatLng();
      this.points[at] = [lat, lng];
      this.heard?.moved();
    });
    marker.on('dragend', () => this.heard?.over());
    marker.on('click', () => {
      if (!isNew) {
        this.heard?.chosen(at);
      }
    });
    marker.addTo(this.layer);
  }
}
