package org.sami.session.api;

import java.util.concurrent.CompletionStage;
import org.sami.spn.value.GeoPoint;

/** What an operator wants of boats without a plan; it comes before what missions want. From any thread. */
public interface GuidedBoats {
    /** Has a boat go to a point, around what is to be avoided. Refused where the point lies in such an area, or where there is no way around. */
    CompletionStage<WayByHand> goTo(String boat, GeoPoint point);

    /** Has an aircraft fly to where it took off, and land there. Refused on the ground, and where it has not said where that is. */
    CompletionStage<WayByHand> goHome(String boat);

    /** Has a boat keep the place where it is, until it is given back. */
    CompletionStage<Void> hold(String boat);

    /** Cancels what the operator asked of a boat: it goes on with the commands of missions. */
    CompletionStage<Void> giveBack(String boat);
}
