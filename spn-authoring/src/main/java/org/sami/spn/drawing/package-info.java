/**
 * The drawing of a net without a window: what is written at vertices and edges, and where vertices, lines and labels lie.
 *
 * <p>{@link org.sami.spn.drawing.NetLayout} makes a {@link org.sami.spn.drawing.NetDrawing}, which painters only paint. Belongs
 * here: the texts, which requirements are implied and not written, layout, and that no label covers another. Does not belong here: fonts,
 * colours, pixels.
 */
@NullMarked
package org.sami.spn.drawing;

import org.jspecify.annotations.NullMarked;
