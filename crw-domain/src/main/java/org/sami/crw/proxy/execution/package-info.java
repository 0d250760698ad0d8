/**
 * Execution of the command whose turn it is: one class for each kind of command. It handles uploads, lost links, refusals and boats without headway.
 *
 * <p>{@link org.sami.crw.proxy.execution.CommandDriver} starts the attempts. Not here: which command has its turn ({@code queue}).
 */
@NullMarked
package org.sami.crw.proxy.execution;

import org.jspecify.annotations.NullMarked;
