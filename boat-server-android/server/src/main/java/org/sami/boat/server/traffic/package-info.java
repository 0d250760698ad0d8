/**
 * Other boats near this one: what is known of them, and how this one gives way to them (docs/decisions, 0320 and 0321). Not here: who tells of them, which is
 * the base over the link, and how motors are set.
 */
package org.sami.boat.server.traffic;
