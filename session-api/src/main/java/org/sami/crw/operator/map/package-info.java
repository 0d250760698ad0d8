/**
 * The contents of the operator's map as immutable values in WGS-84 degrees, radians and metres, and the parts of {@code
 * org.sami.crw.operator.MapModel}: layers, views, tracks, and measurements.
 *
 * <p>Not here: colours, symbols and pixels.
 */
@NullMarked
package org.sami.crw.operator.map;

import org.jspecify.annotations.NullMarked;
