/**
 * The commands that missions have for one boat: whose turn it is by priority, block and age, and what each other one waits for.
 *
 * <p>Does not belong here: what becomes of the command whose turn it is ({@code execution}).
 */
package org.sami.crw.proxy.queue;
