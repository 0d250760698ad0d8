/**
 * Commands that move boats, hold them or stop them: their handlers, the questions that the operator is asked before boats are sent where
 * something is wrong, and what plans hear of each command.
 *
 * <p>{@link org.sami.crw.handler.motion.MotionCommands} is the one way by which activations command boats. Does not belong here: where
 * to ({@code planning}), which command of several a boat carries out ({@code org.sami.crw.proxy}).
 */
package org.sami.crw.handler.motion;
