/**
 * Drawings of nets: where vertices, lines and labels lie, and SVG and PNG of it. Needs no display.
 *
 * <p>{@link org.sami.crw.sim.drawing.NetDrawing} is the geometry, for whoever paints. What is written belongs to
 * {@code org.sami.spn.drawing}; windows and what a mouse does do not belong here.
 */
package org.sami.crw.sim.drawing;
