package org.sami.spn.plannet;

import java.util.List;
import java.util.Optional;
import org.sami.spn.model.Plan;

/** The mission of a sub-mission that is followed, as the sub-mission sees it. */
interface ChildMission {
    /** The child's plan. */
    Plan plan();

    /** The places of the net that stand for those of the plan. */
    MissionPlaces places();

    /** The tokens that can come to its places. */
    PossibleTokens possible();

    /** All places of the net that stand for the mission and its sub-missions. */
    List<Integer> owned();

    /** Its own sub-missions that are followed. */
    List<? extends StartedChild> children();

    /** The one that is followed on a place. */
    Optional<? extends StartedChild> child(String place);
}
