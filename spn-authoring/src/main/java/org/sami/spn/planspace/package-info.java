/**
 * What the states that a plan's net reaches say to people: the answers to the queries of the plan, where tokens gather, what never fires, and the graph to be drawn
 * (thesis, sections 4.2 and 4.3).
 *
 * <p>Does not belong here: the translation of plans to nets ({@code org.sami.spn.plannet}), searches of nets (module {@code petri}), searches on the engine itself
 * ({@code org.sami.spn.statespace}).
 */
@NullMarked
package org.sami.spn.planspace;

import org.jspecify.annotations.NullMarked;
