/**
 * What is to be drawn on the operator's map, as immutable values in WGS-84 degrees, radians and metres, and the parts from which {@code
 * org.sami.crw.operator.MapModel} puts it together: layers, views, tracks, and what sensors measured.
 *
 * <p>Does not belong here: colours, symbols and pixels.
 */
package org.sami.crw.operator.map;
