/**
 * The commands that missions have for one boat: their order by priority, block and age, and what each waiting command waits for.
 *
 * <p>Not here: executing the command whose turn it is ({@code execution}).
 */
@NullMarked
package org.sami.crw.proxy.queue;

import org.jspecify.annotations.NullMarked;
