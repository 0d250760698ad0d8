/**
 * Missions as the operator sees them: where their tokens stand, what they wait for, their buttons and tasks, and what their end or a
 * task's move would change. Immutable values, and the questions to the engine that yield them.
 *
 * <p>Does not belong here: when they are asked for ({@code org.sami.crw.operator}), what rules say ({@code org.sami.spn.engine}).
 */
@NullMarked
package org.sami.crw.operator.mission;

import org.jspecify.annotations.NullMarked;
