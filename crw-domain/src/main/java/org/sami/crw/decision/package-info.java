/**
 * How decisions are shown and answered: their presentation as their markups say, answers files, and an operator that is simulated.
 *
 * <p>Does not belong here: what lies before the operator ({@code org.sami.crw.operator}), when an answer is given (the host's clock
 * decides), what decisions mean to a plan ({@code spn.engine}).
 */
@NullMarked
package org.sami.crw.decision;

import org.jspecify.annotations.NullMarked;
