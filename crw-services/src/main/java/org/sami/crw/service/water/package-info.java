/**
 * Where boats may go: areas as polygons on a plane, no-go areas, the area to stay in.
 *
 * <p>Belongs here: the conversion of areas to JTS geometries, with the checks that make an area one, and questions about a place.
 * Does not belong here: ways ({@code crw.service.path}).
 */
@NullMarked
package org.sami.crw.service.water;

import org.jspecify.annotations.NullMarked;
