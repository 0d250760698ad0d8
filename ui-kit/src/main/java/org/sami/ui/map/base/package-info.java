/**
 * Base maps without a window: files of raster tiles and of outlines, read within a budget, and painted tile by tile off the event thread.
 *
 * <p>Belongs here: what a file of a base map holds, its limits, its pictures. Does not belong here: when files are read and where pictures are
 * shown ({@link org.sami.ui.map}).
 */
@NullMarked
package org.sami.ui.map.base;

import org.jspecify.annotations.NullMarked;
