/**
 * The engine: a deterministic function from state and input to state and effects (SEMANTICS; thesis, Algorithms 1 to 3).
 *
 * <p>Belongs here: firing rules, one class per rule, the state they work on and questions about it. Does not belong here:
 * threads, clocks, files, and anything that knows one domain.
 */
package org.sami.spn.engine;
