/**
 * A session as it is followed by its inputs and its rows of telemetry alone, for models that show it: elsewhere while it runs, or later from its
 * journal. Nothing that acts on boats.
 *
 * <p>Not here: how inputs and rows arrive ({@code org.sami.session.client}), and the time line of a replay ({@code org.sami.crw.replay}).
 */
@NullMarked
package org.sami.session.follow;

import org.jspecify.annotations.NullMarked;
