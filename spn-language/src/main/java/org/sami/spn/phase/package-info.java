/**
 * The phase chart of a plan: what its marked actions do, phase by phase and actor by actor, for people who do not read nets
 * (thesis 5.2.3).
 *
 * <p>Belongs here: the chart as data and what a running mission has done of it. Does not belong here: how it is painted.
 */
@NullMarked
package org.sami.spn.phase;

import org.jspecify.annotations.NullMarked;
