/**
 * What is written on the drawing of a net: the words of vertices and edges.
 *
 * <p>Belongs here: the texts, and which requirements are implied and not written. Does not belong here: where something is drawn, fonts,
 * colours, windows.
 */
package org.sami.spn.drawing;
