/**
 * The background map of the page: raster tiles of one file.
 *
 * <p>Belongs here: reading tiles as bytes. Does not belong here: drawing them, which browsers do ({@code org.sami.ui.map.base} does it for windows), and HTTP
 * ({@code org.sami.session.server}).
 */
@NullMarked
package org.sami.session.map;

import org.jspecify.annotations.NullMarked;
