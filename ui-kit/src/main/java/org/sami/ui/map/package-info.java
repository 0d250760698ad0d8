/**
 * The map of both windows, on JXMapViewer2. It never waits for a network or a file: base maps are read off the event thread, and
 * tiles that are not read yet stay empty.
 *
 * <p>Belongs here: the view, its layers and tools, base maps. Does not belong here: geography without a window
 * ({@link org.sami.ui.geo}), and what a layer's vehicles are.
 */
@NullMarked
package org.sami.ui.map;

import org.jspecify.annotations.NullMarked;
