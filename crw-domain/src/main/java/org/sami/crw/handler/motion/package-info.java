/**
 * Commands that move, hold or stop boats: their handlers, the questions to the operator where something is wrong before boats go, and the reports of
 * each command to plans.
 *
 * <p>Activations command boats only through {@link org.sami.crw.handler.motion.MotionCommands}. Not here: destinations ({@code planning}), and which
 * of several commands a boat executes ({@code org.sami.crw.proxy}).
 */
@NullMarked
package org.sami.crw.handler.motion;

import org.jspecify.annotations.NullMarked;
