/**
 * Pictures of nets: SVG and PNG of a drawing. Needs no display.
 *
 * <p>What is written, and where everything lies, belongs to {@code org.sami.spn.drawing}; windows and what a mouse does do not belong here.
 */
package org.sami.crw.sim.drawing;
