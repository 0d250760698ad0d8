/**
 * Speaks the boat link for vehicles that speak MAVLink, in the process of the base: what a base commands becomes modes, missions and commands of the autopilot,
 * and what the autopilot reports becomes what boats say (docs/mavlink.md).
 *
 * <p>Not here: the protocol of vehicles, which module {@code mavlink} has, and proxies, plans and windows, which know only boats.
 */
@NullMarked
package org.sami.crw.mavlink;

import org.jspecify.annotations.NullMarked;
