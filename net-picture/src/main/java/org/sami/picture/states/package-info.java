/**
 * Paints reachability graphs on a {@link org.sami.picture.Canvas}, in windows and as files.
 *
 * <p>Where boxes and lines lie is made by {@code org.sami.spn.drawing.states}; what a mouse does belongs to windows.
 */
@NullMarked
package org.sami.picture.states;

import org.jspecify.annotations.NullMarked;
