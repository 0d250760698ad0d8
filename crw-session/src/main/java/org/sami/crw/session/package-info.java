/**
 * A session: what every front opens that runs plans on boats, such as a window, a console, {@code crw run} or a test.
 *
 * <p>Belongs here: the engine's host, the domain on it, the links to boats, journal and telemetry put together, with their threads.
 * Does not belong here: what is simulated (a fleet's seed, speed, charges), what a run reports of itself, and what is kept of a session ({@code archive}).
 */
@NullMarked
package org.sami.crw.session;

import org.jspecify.annotations.NullMarked;
