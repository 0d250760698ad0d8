/**
 * What vehicles hold of missions, fences and rally points, and the protocol that moves them.
 *
 * <p>The transfers have no thread and no clock: messages and moments go in, messages come out.
 */
@NullMarked
package org.sami.mavlink.mission;

import org.jspecify.annotations.NullMarked;
