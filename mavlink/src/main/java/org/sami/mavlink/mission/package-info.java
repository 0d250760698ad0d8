/**
 * The lists that vehicles hold (missions, fences, rally points), and how they are read, replaced and read back.
 *
 * <p>Not here: what lists are good for, which plans know.
 */
@NullMarked
package org.sami.mavlink.mission;

import org.jspecify.annotations.NullMarked;
