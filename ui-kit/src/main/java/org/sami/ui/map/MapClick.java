package org.sami.ui.map;

import java.util.Optional;
import org.sami.spn.value.GeoPoint;

/**
 * A click on a map on which nothing is drawn.
 *
 * @param at where, as a point
 * @param item id of what lies there, of the topmost layer; none where only the map is
 * @param x where, in pixels of the view, for a menu
 * @param additive whether it adds to what is chosen: Ctrl or Shift is held
 * @param menu whether it asks for a menu
 * @param twice whether it is the second of two
 */
public record MapClick(
        GeoPoint at, Optional<String> item, int x, int y, boolean additive, boolean menu, boolean twice) {}
