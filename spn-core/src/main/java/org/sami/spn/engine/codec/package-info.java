/**
 * The bytes of a state, exact and versioned. Used by the engine alone.
 *
 * <p>Belongs here: writing and reading of states and of what they contain. Does not belong here: anything that changes a state
 * further. Knows {@code state} and {@code net}.
 *
 * <p>Read {@code StateWriter}; {@code StateReader} is its mirror.
 */
package org.sami.spn.engine.codec;
