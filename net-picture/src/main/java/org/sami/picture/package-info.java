/**
 * Pictures of nets: SVG and PNG of a drawing, and a {@link org.sami.picture.Canvas} for whoever writes another format. Needs no display.
 *
 * <p>What is written, and where everything lies, belongs to {@code org.sami.spn.drawing}; windows and what a mouse does do not belong here.
 */
@NullMarked
package org.sami.picture;

import org.jspecify.annotations.NullMarked;
