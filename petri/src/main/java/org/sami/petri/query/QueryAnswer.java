package org.sami.petri.query;

import java.util.Optional;
import org.sami.petri.graph.FiringSequence;
import org.sami.petri.graph.ReachabilityGraph;

/**
 * What a search says to a query.
 *
 * @param verdict yes or no where it is proved, else unknown
 * @param words the answer in words
 * @param witness a run that shows it, where the answer is that something happens
 * @param graph what was searched
 */
public record QueryAnswer(NetVerdict verdict, String words, Optional<FiringSequence> witness, ReachabilityGraph graph) {
    /** How a query is answered. */
    public enum NetVerdict {
        YES,
        NO,
        /** The search was bounded, and found nothing. */
        UNKNOWN
    }
}
