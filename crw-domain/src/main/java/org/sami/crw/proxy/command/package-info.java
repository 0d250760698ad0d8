/**
 * What missions have boats do: follow a path, keep a station, take a panorama, stop; the points that are driven along, and how far they
 * have come on their way to the boat. Immutable values.
 *
 * <p>Does not belong here: whose turn it is ({@code queue}), how a boat is brought to do it ({@code execution}).
 */
@NullMarked
package org.sami.crw.proxy.command;

import org.jspecify.annotations.NullMarked;
