/**
 * Our boats in ground stations of other makers, for the command and for the operator's window: where they are shown, and whether a station answers.
 *
 * <p>Not here: what boats say there, which is in {@code boat.mavlink}.
 */
@NullMarked
package org.sami.crw.cli.station;

import org.jspecify.annotations.NullMarked;
