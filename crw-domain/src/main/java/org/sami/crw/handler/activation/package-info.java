/**
 * What all handlers read of an activation and answer with: its fields and markups, the boats to which it speaks, the areas that its plan
 * keeps boats in, what the operator is told of it, and the input events by which plans hear what became of it.
 *
 * <p>Does not belong here: what is then done ({@code motion}, {@code planning}, {@code boat}).
 */
package org.sami.crw.handler.activation;
