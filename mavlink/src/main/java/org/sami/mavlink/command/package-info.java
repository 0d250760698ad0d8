/**
 * Commands to vehicles and what becomes of them: sent again until they are answered, with progress, and the autopilot's words where it refuses.
 *
 * <p>Not here: threads and links, which {@code mavlink.base} has, and lists of items, which {@code mavlink.mission} transfers.
 */
@NullMarked
package org.sami.mavlink.command;

import org.jspecify.annotations.NullMarked;
