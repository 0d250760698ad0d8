package org.sami.spn.plannet;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/** What a case of a firing supposes of the generic tokens, and does with them. Filled by {@link GenericOptions}, then only read. */
final class GenericOption {
    final CaseArcs arcs = new CaseArcs();
    final List<PlanNetMove> moves = new ArrayList<>();
    final Set<Integer> edges = new TreeSet<>();
    final Set<String> left = new TreeSet<>();
    /** How many each group of requirements with numbers selects. */
    final Map<String, Integer> picked = new TreeMap<>();
    /** How many of those that are selected sub-missions brought back. */
    int returned;

    /** The groups that leave some. */
    final Set<String> more = new TreeSet<>();
}
