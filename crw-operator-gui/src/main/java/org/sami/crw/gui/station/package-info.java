/**
 * The session's simulated boats in ground stations of other makers: where they are shown, and whether a station listens.
 *
 * <p>Not here: what boats say there, which is in {@code boat.mavlink}.
 */
@NullMarked
package org.sami.crw.gui.station;

import org.jspecify.annotations.NullMarked;
