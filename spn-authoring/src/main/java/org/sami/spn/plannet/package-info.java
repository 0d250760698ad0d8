/**
 * Plans as Petri nets (thesis 4.1): what a plan with a team of robots can do, as a place/transition net that {@code org.sami.petri} searches, and the way back
 * from its markings and runs to places, tokens and firings of the plan.
 *
 * <p>Belongs here: the translation, the list of what it leaves to chance, queries in the words of a plan. Does not belong here: searches of nets
 * ({@code org.sami.petri}), runs on the engine itself ({@code spn.statespace}), robots of any domain.
 *
 * <p>{@link org.sami.spn.plannet.PlanNet} is where to begin.
 */
@NullMarked
package org.sami.spn.plannet;

import org.jspecify.annotations.NullMarked;
