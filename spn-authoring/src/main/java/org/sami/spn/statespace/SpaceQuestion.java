package org.sami.spn.statespace;

import java.util.List;

/** A deep check that asks something of the states that a plan reaches. */
interface SpaceQuestion extends DeepCheck {
    /** What it finds among them. */
    List<DeepFinding> findings(Exploration found, DeepRequest request);

    /** What it says of them, in a few words. */
    String result(Exploration found, DeepRequest request);

    /** Whether it asks what happens where a robot is dropped. */
    default boolean dropsRobots() {
        return false;
    }

    @Override
    default DeepResult run(DeepRequest request, SearchWatch watch) {
        Exploration found = Exploration.of(request, watch, dropsRobots());
        String summary = SearchWords.looked(found, request) + result(found, request) + SearchWords.rest(found);
        return new DeepResult(findings(found, request), found.looked(), found.isComplete(), summary);
    }
}
