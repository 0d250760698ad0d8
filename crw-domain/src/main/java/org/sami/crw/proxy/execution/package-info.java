/**
 * How a boat is brought to carry out the command whose turn it is: one class for each kind of command, over uploads, lost links, refusals and
 * boats that do not get on.
 *
 * <p>{@link org.sami.crw.proxy.execution.CommandDriver} has them tried. Does not belong here: which command that is ({@code queue}).
 */
package org.sami.crw.proxy.execution;
