/**
 * Trying a plan step by step on the engine itself: what is tried is what runs.
 *
 * <p>Belongs here: starting a plan of a project from its start or from a marking, taking and undoing steps, saying what is possible
 * now and why something is not, recording the steps as a test case. Does not belong here: threads, journals and handlers
 * ({@code spn.host}), how a test case is written down ({@code spn.json}), what a plan means ({@code spn.engine}).
 *
 * <p>{@link org.sami.spn.stepping.Stepper} is where to begin. Nobody but its caller answers, and time stands still unless a step lets
 * it pass.
 */
@NullMarked
package org.sami.spn.stepping;

import org.jspecify.annotations.NullMarked;
