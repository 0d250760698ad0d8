/**
 * The model view: the net of the open plan, with gestures, keys and commands that change it. Each is an edit of the document. What edits do
 * stands in {@code org.sami.spn.edit}, where things lie in {@code org.sami.spn.drawing}, how they are painted in {@code org.sami.ui.net};
 * palettes put things onto the net as {@link org.sami.dreamm.canvas.NetDrop}s.
 */
@NullMarked
package org.sami.dreamm.canvas;

import org.jspecify.annotations.NullMarked;
