/**
 * What all handlers share about an activation: its fields and markups, the boats that it addresses, the areas of its plan, messages to the operator
 * about it, the input events that report its result to plans, and what its mission remembers of that across restarts of the base.
 *
 * <p>Not here: the work itself ({@code motion}, {@code planning}, {@code boat}).
 */
@NullMarked
package org.sami.crw.handler.activation;

import org.jspecify.annotations.NullMarked;
