/**
 * Deep checks: what is found only by running a plan, with a bound on how far. They take seconds, can be watched and stopped, and bring
 * witnesses, runs that end where the finding is.
 *
 * <p>Belongs here: searching the states that a plan can reach on the engine itself, and the questions asked of them. Does not belong here:
 * checks that look at the drawing alone ({@code spn.analysis}), steps and samples ({@code spn.stepping}).
 *
 * <p>{@link org.sami.spn.statespace.DeepCheck} is where to begin.
 */
@NullMarked
package org.sami.spn.statespace;

import org.jspecify.annotations.NullMarked;
