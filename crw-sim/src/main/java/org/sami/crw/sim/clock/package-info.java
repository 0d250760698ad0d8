/**
 * Virtual time: the scheduler that simulated parts are written against, and its deterministic implementation.
 *
 * <p>Here belongs what decides when something happens in the simulated world. What happens belongs to the packages of
 * hulls, links and operators; nothing here reads the wall clock.
 */
@NullMarked
package org.sami.crw.sim.clock;

import org.jspecify.annotations.NullMarked;
