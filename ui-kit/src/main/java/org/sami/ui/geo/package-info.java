/**
 * Geography without a window: projection, measuring, coordinates as text, and the model of a point, path or area that somebody draws.
 *
 * <p>Belongs here: what a map shows and edits, as values. Does not belong here: Swing, painting, files.
 */
@NullMarked
package org.sami.ui.geo;

import org.jspecify.annotations.NullMarked;
