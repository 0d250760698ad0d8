/**
 * The bytes of a state, exact and versioned. Used by the engine alone.
 *
 * <p>Belongs here: writing and reading of states and of what they contain. Does not belong here: anything that changes a state
 * further. Knows {@code state} and {@code net}.
 *
 * <p>Begin with {@link org.sami.spn.engine.codec.StateEncoder}; {@link org.sami.spn.engine.codec.StateDecoder} reads what it writes.
 */
@NullMarked
package org.sami.spn.engine.codec;

import org.jspecify.annotations.NullMarked;
